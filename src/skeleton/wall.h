/* The walls that the void sees, as points spread over them: how much area each
 * stands for, and which voxel of the void sees it. */
#ifndef SKELETON_WALL_H
#define SKELETON_WALL_H

#include <stdatomic.h>

#include "world/world.h"
#include "skeleton/voxels.h"

struct wall_point {
    size_t voxel;   /* of the void, before the wall */
    double area;    /* that the point stands for; units squared */
    vec3 direction; /* unit, along an axis: how the void looks at it */
    struct intersection at;
};

/* Whether what a ray met is a wall: matter (skeleton/matter.h) that stops
 * light there. */
bool wall_stops(const uint8_t *marks, const struct intersection *at);

/* Areas are those of the true surfaces: right in the sum over many points (0.5
 * % over a hundred voxels), not for each voxel. The array is for memory_free;
 * the same for any number of threads; not all of them once *stop is non-zero
 * (may be NULL). */
struct wall_point *wall_points(const struct world *world,
                               const struct voxels *v, unsigned threads,
                               const atomic_int *stop, size_t *count);

#endif
