/* The void as flooded with light: from lights, emitters and the camera through
 * faces of empty voxels. It needs no inside and no outside of anything. */
#ifndef SKELETON_FLOOD_H
#define SKELETON_FLOOD_H

#include "skeleton/void.h"

struct flood {
    struct void_space *space;
    const struct world *world;
    const uint8_t *leaf_marks;  /* see matter.h */
    const uint8_t *voxel_marks; /* see voxelise.h */
    size_t *stack;
    size_t stack_count;
    size_t part_capacity;
};

/* Fills label, parts, lights and camera of the space, whose voxels are empty
 * where nothing is, and then makes matter of all that was not reached. */
void flood_space(struct flood *flood, const struct camera *camera);

#endif
