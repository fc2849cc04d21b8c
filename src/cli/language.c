/* --language-server: see language.h. */
#include "cli/language.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

#define PROGRAM "glim-language-server"

void language_server(const struct options *options, struct diag *diag)
{
    char name[PATH_MAX + sizeof PROGRAM];
    ssize_t length = readlink("/proc/self/exe", name, PATH_MAX);
    name[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(name, '/');
    strcpy(slash ? slash + 1 : name, PROGRAM);

    struct arena *arena = arena_new(0);
    const struct parse_options *parse = &options->parse;
    size_t standard = 0;
    while (parse->standard_paths[standard])
        standard++;
    char **arguments =
        ARENA_ARRAY(arena, char *, parse->include_path_count + standard + 2);
    size_t count = 0;
    arguments[count++] = name;
    for (size_t i = 0; i < parse->include_path_count; i++)
        arguments[count++] =
            arena_printf(arena, "+L%s", parse->include_paths[i]);
    for (size_t i = 0; i < standard; i++)
        arguments[count++] =
            arena_printf(arena, "+S%s", parse->standard_paths[i]);
    execv(name, arguments);
    if (errno == ENOENT)
        diag_print(diag, DIAG_ERROR, span_none(),
                   "install libjansson-dev and type make",
                   "glim was built without its language server, which needs "
                   "Jansson");
    else
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't run '%s': %s",
                   name, strerror(errno));
    arena_free(arena);
}
