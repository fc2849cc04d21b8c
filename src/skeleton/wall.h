/* The walls that the void sees: how large they are, what they give back, what
 * they emit, for each voxel of the void beside them. */
#ifndef SKELETON_WALL_H
#define SKELETON_WALL_H

#include "base/rgb.h"
#include "embree/world.h"
#include "skeleton/voxels.h"

/* What the void sees of the walls at one voxel. */
struct wall {
    size_t voxel;
    double area;  /* true area, not that of voxel faces; units squared */
    rgb albedo;   /* mean diffuse reflectance: pigment * diffuse */
    rgb emission; /* mean emitted radiance: pigment * emission */
};

/* At most one for each voxel, in the order of voxels; for memory_free. Areas
 * are estimates that are right in the sum over many voxels (0.5 % over a
 * hundred of them), not for each. `marks` are those of the leaves (matter.h).
 * The same for any number of threads. */
struct wall *walls_measure(const struct world *world, const struct voxels *v,
                           const uint8_t *marks, unsigned threads,
                           size_t *count);

#endif
