/* GNU make's jobserver, as its client ("Job Slots", GNU make manual; POSIX
 * Jobserver Interaction): a process that make has started may run one thread;
 * for each other it takes a token from a pipe that all share, and puts it back.
 * Under `make -j8` twenty processes so keep eight cores busy, and no more. */
#ifndef BASE_JOBSERVER_H
#define BASE_JOBSERVER_H

#include <stdbool.h>

enum jobserver {
    JOBSERVER_NONE,   /* not started by make -j: as many threads as one likes */
    JOBSERVER_CLOSED, /* by make -j, but the rule has no '+': make lets us have
                       * no token */
    JOBSERVER_OPEN,
};

/* What MAKEFLAGS and the files that are open say; found out once. */
enum jobserver jobserver_state(void);

/* Takes a token if there is one, without waiting. */
bool jobserver_take(char *token);
void jobserver_give(char token);

#endif
