/* What many leaves have in common is kept once: where they are and how they are
 * seen. Those kept last are looked at, since the parts of an object are most
 * often in one place, and objects that follow each other look alike. */
#ifndef WORLD_SHARED_H
#define WORLD_SHARED_H

#include "world/solid.h"

enum { SHARED_RECENT = 4 };

/* Zeroed at first. */
struct shared {
    const struct pose *poses[SHARED_RECENT];
    const struct leaf_look *looks[SHARED_RECENT];
    unsigned next_pose, next_look;
};

/* That pose, in `arena`; NULL if the map has no inverse. `kept` lives as long
 * and may be the same map. */
const struct pose *shared_pose(struct shared *shared, struct arena *arena,
                               const affine *outward, const affine *kept);

/* That look, in `arena`, and what its textures are said of it. It is compared
 * byte by byte: zeroed before it was filled in. */
const struct leaf_look *shared_look(struct shared *shared, struct arena *arena,
                                    const struct leaf_look *look);

#endif
