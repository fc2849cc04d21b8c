/* The user's editor. */
#ifndef VIEW_EDITOR_H
#define VIEW_EDITOR_H

#include <stdbool.h>

/* Starts $VISUAL, or else $EDITOR, on a line of a file, and doesn't wait for
 * it. False: neither is set, or the system starts no program. */
bool editor_open(const char *file, unsigned line);

#endif
