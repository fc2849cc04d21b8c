/* A directory of one's own for files that are soon gone. */
#ifndef BASE_SCRATCH_H
#define BASE_SCRATCH_H

#include "base/arena.h"

/* Makes a new directory NAME-XXXXXX, which nobody else may look into, where
 * TMPDIR says, else in /tmp. Its path, in `arena`; NULL with errno if it can't
 * be made, and then *tried (if not NULL) is what was tried. */
const char *scratch_make(const char *name, struct arena *arena,
                         const char **tried);

/* Removes it and the files in it; there must be no directories. NULL is
 * none. */
void scratch_remove(const char *path);

#endif
