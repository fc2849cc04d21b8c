/* --watch: waiting for a file of the scene to change. */
#ifndef CLI_WATCH_H
#define CLI_WATCH_H

#include <stdatomic.h>

#include "base/file_list.h"

/* Returns true when a file has changed, false when `stop` was set. */
bool watch_wait(const struct file_list *files, const atomic_int *stop);

#endif
