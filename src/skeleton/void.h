/* The void of a scene: where light can be, in voxels; its parts; its open
 * borders. */
#ifndef SKELETON_VOID_H
#define SKELETON_VOID_H

#include <stdatomic.h>

#include "world/world.h"
#include "skeleton/grid.h"
#include "skeleton/voxels.h"

/* A part of the void that is connected over voxel faces. */
struct void_part {
    size_t volume; /* voxels */
    size_t lights; /* whose light starts in it, or comes in from outside */
    bool emitter;  /* a surface with an emission faces it */
    bool camera;   /* the camera is in it, or sees into it from outside */
    bool sky;      /* it reaches the border of the grid */
};

/* Where a light of world_lights is. */
struct void_light {
    size_t voxel; /* VOXEL_NONE: outside of the grid, or shut in by matter */
    bool outside; /* of the grid: it shines in through the border */
};

struct void_space {
    struct voxels voxels; /* empty: 1 only where some light or the camera gets
                           * to; all else is 0 */
    uint32_t *label;      /* by voxel: the number of its part from 1 on, or 0 */
    struct void_part *parts; /* part number n is parts[n - 1] */
    size_t part_count;
    struct void_light *lights; /* as many as world_lights */
    size_t light_count;
    size_t camera; /* its voxel, or VOXEL_NONE: outside, or in matter */
    bool dark;     /* no light gets into the part that it is in */
};

/* Voxels and void of a scene; free with void_free. Warns of lights inside
 * matter and of a camera without light. NULL after an error was printed, or
 * once *stop is non-zero (may be NULL). The same for any number of threads. */
struct void_space *void_new(const struct scene *scene,
                            const struct world *world, struct grid_wish wish,
                            unsigned threads, const atomic_int *stop,
                            struct diag *diag);
void void_free(struct void_space *space);

/* The void voxel that a point of a surface sees, on the side that `normal`
 * (unit) points to, or VOXEL_NONE. */
size_t void_facing(const struct void_space *space, vec3 point, vec3 normal);

#endif
