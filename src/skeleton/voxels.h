/* The scene as cubes of equal size: which are void (light can be there) and
 * which hold matter. */
#ifndef SKELETON_VOXELS_H
#define SKELETON_VOXELS_H

#include <stddef.h>
#include <stdint.h>

#include "base/affine.h"

#define VOXEL_NONE ((size_t)-1) /* instead of an index */

enum {
    VOXELS_RESOLUTION = 128,     /* voxels along the longest side, by default */
    VOXELS_RESOLUTION_LEAST = 8, /* fewer are taken for so many */
};

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

/* The whole grid as a box of the world. */
static inline struct box3 voxels_box(const struct voxels *v)
{
    vec3 size = { v->size[0], v->size[1], v->size[2] };
    return (struct box3){ v->origin, vec3_along(v->origin, size, v->edge) };
}

static inline vec3 voxels_centre(const struct voxels *v, const int *at)
{
    vec3 offset = { at[0] + 0.5, at[1] + 0.5, at[2] + 0.5 };
    return vec3_along(v->origin, offset, v->edge);
}

static inline bool voxels_holds(const struct voxels *v, const int *at)
{
    return at[0] >= 0 && at[0] < v->size[0] && at[1] >= 0 &&
           at[1] < v->size[1] && at[2] >= 0 && at[2] < v->size[2];
}

/* The voxel a point is in; false if that is not in the grid. */
static inline bool voxels_find(const struct voxels *v, vec3 point, int *at)
{
    vec3 p = vec3_scale(vec3_sub(point, v->origin), 1 / v->edge);
    if (!(p.x >= 0 && p.x < v->size[0] && p.y >= 0 && p.y < v->size[1] &&
          p.z >= 0 && p.z < v->size[2]))
        return false;
    at[0] = (int)p.x;
    at[1] = (int)p.y;
    at[2] = (int)p.z;
    return true;
}

/* The empty voxel that holds the point, or VOXEL_NONE. */
static inline size_t voxels_empty_at(const struct voxels *v, vec3 point)
{
    int at[3];
    if (!voxels_find(v, point, at))
        return VOXEL_NONE;
    size_t index = voxels_index(v, at[0], at[1], at[2]);
    return v->empty[index] ? index : VOXEL_NONE;
}

/* Of the empty neighbours of the point's voxel whose centres are in front of
 * the point, on the side of `normal`, the one most along it; or VOXEL_NONE. */
size_t voxels_empty_beside(const struct voxels *v, vec3 point, vec3 normal);

/* The place of the voxel with this index. */
static inline void voxels_place(const struct voxels *v, size_t index, int *at)
{
    size_t width = (size_t)v->size[0], height = (size_t)v->size[1];
    at[0] = (int)(index % width);
    at[1] = (int)(index / width % height);
    at[2] = (int)(index / width / height);
}

#endif
