/* Waiting for changed files: see watch.h. They are looked at ten times a
 * second, which works on every file system, those of a network too. */
#include "cli/watch.h"

#include <poll.h>

enum { WATCH_STEP = 100 }; /* ms */

bool watch_wait(const struct file_list *files, const atomic_int *stop)
{
    while (!atomic_load(stop)) {
        if (file_list_changed(files))
            return true;
        poll(NULL, 0, WATCH_STEP);
    }
    return false;
}
