/* glim-language-server [+LDIR ...] [+SDIR ...] [+RWHO or +AWHO
 * [+DDIR +BDIR +TDIR ...] ...]: what `glim --language-server` runs, with the
 * folders that it would search itself, +S those of POV-Ray, and what scenes may
 * read (cli/language.c). */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "base/parallel.h"
#include "language/server.h"

struct session {
    int argc;
    char **argv;
    int out;
    int status;
};

static void session_run(void *context)
{
    struct session *session = context;
    struct arena *arena = arena_new(0);
    struct server server = { .wire = { .in = STDIN_FILENO,
                                       .out = session->out } };
    const char **folders =
        ARENA_ARRAY(arena, const char *, (size_t)session->argc);
    const char **standard =
        ARENA_ARRAY(arena, const char *, (size_t)session->argc);
    size_t standard_count = 0;
    struct permit_list *list = NULL;
    for (int i = 1; i < session->argc; i++) {
        const char *folder = session->argv[i] + 2;
        char letter = session->argv[i][1];
        if (letter == 'R' || letter == 'A') {
            list = permits_begin(&server.library.permits, arena, folder);
            list->above = letter == 'A';
        } else if (list && strchr("DBT", letter))
            permit_add(list, arena,
                       (struct permit){ folder, letter != 'D', letter == 'T' });
        if (strncmp(session->argv[i], "+L", 2) == 0)
            folders[server.library.folder_count++] = folder;
        if (strncmp(session->argv[i], "+S", 2) == 0)
            standard[standard_count++] = folder;
    }
    server.library.standard = standard;
    server.library.folders = folders;
    server.library.arena = arena;
    server.library.words = word_table_new(arena);
    server.grammar = grammar_new(arena);
    session->status = server_run(&server);
    wire_free(&server.wire);
    while (server.library.pages)
        page_remove(&server.library, server.library.pages);
    arena_free(arena);
}

/* Whatever else writes to standard output writes to standard error: the
 * protocol has it alone. */
int main(int argc, char **argv)
{
    struct session session = { argc, argv, dup(STDOUT_FILENO), 1 };
    if (session.out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
        fprintf(stderr, "glim: error: there is no standard output\n");
        return 1;
    }
    fcntl(session.out, F_SETFD, FD_CLOEXEC);
    signal(SIGPIPE, SIG_IGN);
    if (!parallel_call(session_run, &session))
        fprintf(stderr, "glim: error: the system gives no thread\n");
    return session.status;
}
