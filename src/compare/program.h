/* Other programs: found, run without a shell, measured, stopped. */
#ifndef COMPARE_PROGRAM_H
#define COMPARE_PROGRAM_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/arena.h"
#include "compare/report.h"

/* The program that the environment variable names, by path or by a name along
 * PATH; else the file `name` in the directory of this program, if `beside`;
 * else `name` along PATH. NULL if it isn't there or can't be run. */
const char *program_find(const char *variable, const char *name, bool beside,
                         struct arena *arena);

/* `letters` (+I, +O, +L) and a name as POV-Ray reads them: it splits words at
 * blanks and semicolons, even those of its command line, unless they stand in
 * quotes. In `arena`. */
char *program_povray_name(const char *letters, const char *name,
                          struct arena *arena);

enum program_end {
    PROGRAM_DONE,    /* exit status 0 */
    PROGRAM_FAILED,  /* another status, a signal, or it couldn't be started */
    PROGRAM_STOPPED, /* *stop became non-zero: it was killed */
};

/* Runs the file words[0] with the arguments (NULL-terminated), reading
 * nothing. Standard output and error go to the file `log`, which is replaced.
 * `times` gets what it took. */
enum program_end program_run(char *const *words, const char *log,
                             const atomic_int *stop, struct times *times);

#endif
