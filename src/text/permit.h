/* Which files a scene may have read: lists of directories. */
#ifndef TEXT_PERMIT_H
#define TEXT_PERMIT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

struct permit {
    const char *directory; /* with no link in it */
    bool below;            /* what is deeper in it too */
    bool links;            /* and what links in it, of files, lead to */
};

/* What one file or option permits. */
struct permit_list {
    const char *where; /* that says so: a file's name, an option */
    bool above; /* a scene may read what is in the directory above its own */
    struct permit *items;
    size_t count, capacity;
};

/* All lists must permit a file; none at all permits everything. */
struct permits {
    struct permit_list *items;
    size_t count, capacity;
};

/* An empty list at the end, into which permit_add writes. */
struct permit_list *permits_begin(struct permits *permits, struct arena *arena,
                                  const char *where);

/* Permits files as `permit` says; a relative directory is seen from the current
 * one, now. One that doesn't exist is left out. */
void permit_add(struct permit_list *list, struct arena *arena,
                struct permit permit);

/* Permits what is in the directory of a scene and deeper; if the list says so
 * in that above it, unless that holds the homes of all users, or everything. */
void permit_beside(struct permit_list *list, struct arena *arena,
                   const char *folder);

/* The first list that does not permit to read the file at `path`, which exists:
 * links and ".." are followed first. NULL: it may be read. `permits` may be
 * NULL. */
const struct permit_list *permits_denier(const struct permits *permits,
                                         const char *path);

/* The same for seeing what a directory holds. */
const struct permit_list *permits_denier_of(const struct permits *permits,
                                            const char *directory);

#endif
