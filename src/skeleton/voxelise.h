/* Voxels of the scene's surfaces: the supercover, every voxel that a surface
 * touches (Cohen-Or and Kaufman 1995), so that no wall leaks, however thin. */
#ifndef SKELETON_VOXELISE_H
#define SKELETON_VOXELISE_H

#include <stdatomic.h>

#include "world/world.h"
#include "skeleton/voxels.h"

/* Adds to out[voxels_count(grid)], one byte a voxel, the marks of every leaf
 * whose surface meets it (skeleton/matter.h). Only the grid of `grid` is
 * used, not what is empty in it. The same for any number of threads; not all of
 * it once *stop is non-zero (may be NULL). */
void voxelise(const struct world *world, const struct voxels *grid,
              const uint8_t *marks, unsigned threads, const atomic_int *stop,
              uint8_t *out);

/* The voxels low..high, both included, that a box of the world touches, within
 * the grid; false if none. */
bool voxels_touched(const struct voxels *grid, struct box3 box, int *low,
                    int *high);

/* The parts of it for solids and for triangles. */
void voxelise_solids(const struct world *world, const struct voxels *grid,
                     const uint8_t *marks, unsigned threads,
                     const atomic_int *stop, uint8_t *out);
void voxelise_meshes(const struct world *world, const struct voxels *grid,
                     const uint8_t *marks, unsigned threads,
                     const atomic_int *stop, uint8_t *out);

#endif
