/* The scene as cubes of equal size: which are void (light can be there) and
 * which hold matter. */
#ifndef SKELETON_VOXELS_H
#define SKELETON_VOXELS_H

#include <stddef.h>
#include <stdint.h>

#include "base/vec.h"

struct voxels {
    int size[3]; /* along x, y, z */
    double edge; /* of a cube, world units */
    vec3 origin; /* the low corner of voxel (0,0,0) */
    /* One byte a voxel, x fastest: 1 void, 0 matter. */
    uint8_t *empty;
};

static inline size_t voxels_index(const struct voxels *v, int x, int y, int z)
{
    return ((size_t)z * (size_t)v->size[1] + (size_t)y) * (size_t)v->size[0] +
           (size_t)x;
}

static inline size_t voxels_count(const struct voxels *v)
{
    return (size_t)v->size[0] * (size_t)v->size[1] * (size_t)v->size[2];
}

#endif
