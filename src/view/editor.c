/* $VISUAL +LINE FILE: see editor.h. */
#include "view/editor.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* The words of VISUAL are the shell's to split; file and line are given as
 * arguments, so that nothing in a name is taken for a command. */
static void editor_run(const char *editor, const char *file, unsigned line)
{
    char where[32];
    snprintf(where, sizeof where, "+%u", line);
    execl("/bin/sh", "sh", "-c", "exec $0 \"$1\" \"$2\"", editor, where, file,
          (char *)NULL);
    _exit(127);
}

bool editor_open(const char *file, unsigned line)
{
    const char *editor = getenv("VISUAL");
    if (!editor || !*editor)
        editor = getenv("EDITOR");
    if (!editor || !*editor)
        return false;
    pid_t child = fork();
    if (child == 0) { /* its child is nobody's to wait for */
        if (fork() == 0) {
            setsid();
            editor_run(editor, file, line);
        }
        _exit(0);
    }
    return child > 0 && waitpid(child, NULL, 0) == child;
}
