/* What a box of space may hold of a solid: inside, outside, surface that
 * counts. Conservative, so that voxels miss no wall however thin; told from
 * bounds (scene/cell.h), not from rays. */
#ifndef WORLD_OVERLAP_H
#define WORLD_OVERLAP_H

#include <stdint.h>

#include "world/solid.h"

struct overlap {
    uint8_t marks; /* of all leaves whose surface may be there */
    bool inside, outside;
};

/* The box in the world, about `centre`. `marks` has one byte for each leaf by
 * number: 0 leaves it out as a surface. `last`: the box won't be cut into
 * smaller ones, so shapes without a test of cells are searched in it. Bounds
 * (bounded_by) are left aside: what they hide depends on the viewer. */
struct overlap solid_overlap(const struct solid *solid, vec3 centre, vec3 half,
                             bool last, const uint8_t *marks);

#endif
