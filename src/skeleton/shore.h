/* What was found out about the voxels of the void, kept for those who ask
 * again: six numbers-and-lights a voxel. Most are asked on the shore, at what
 * borders on the void, but panes stand amid it. A value must depend on its
 * voxel and side alone, so that it doesn't matter who asks first, nor whether
 * two do at once. */
#ifndef SKELETON_SHORE_H
#define SKELETON_SHORE_H

#include "base/rgb.h"
#include "skeleton/voxels.h"

enum { SHORE_SIDES = 6 };

struct shore;

/* The light of a side, and how much it counts, in [0, 1]. */
struct shore_light {
    rgb light;
    double weight;
};

/* Of all void voxels; nothing is known. Freed by shore_free. */
struct shore *shore_new(const struct voxels *voxels);
void shore_free(struct shore *shore);

/* False if it isn't known: to be found out and kept. In single precision: what
 * is known is what was kept. */
bool shore_known(const struct shore *shore, size_t voxel, int side,
                 struct shore_light *out);
void shore_keep(const struct shore *shore, size_t voxel, int side,
                struct shore_light *light);

#endif
