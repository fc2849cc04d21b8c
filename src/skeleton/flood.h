/* The void as flooded with light: from lights, emitters and the camera through
 * faces of empty voxels. It needs no inside and no outside of anything. */
#ifndef SKELETON_FLOOD_H
#define SKELETON_FLOOD_H

#include "skeleton/void.h"

/* Voxels reached together. */
struct front {
    uint32_t *voxels;
    size_t count, capacity;
};

struct flood {
    struct void_space *space;
    const struct world *world;
    const uint8_t *leaf_marks;  /* see matter.h */
    const uint8_t *voxel_marks; /* see voxelise.h */
    const atomic_int *stop;     /* non-zero: leave off; NULL: never */
    struct front front[2];      /* what was reached last, and what is now */
    size_t part_capacity;
};

/* Fills label, parts, lights and camera of the space, whose voxels are empty
 * where nothing is, and then makes matter of all that was not reached. Once it
 * is stopped they are of no use. */
void flood_space(struct flood *flood, const struct camera *camera);

#endif
