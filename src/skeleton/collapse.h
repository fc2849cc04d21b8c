/* From the void to its curvilinear skeleton: parallel directional collapse of
 * the cubical complex (Chaussard and Couprie, "Surface thinning in 3D cubical
 * complexes", IWCIA 2009), with branches kept by how long they live. */
#ifndef SKELETON_COLLAPSE_H
#define SKELETON_COLLAPSE_H

#include <stdatomic.h>

#include "skeleton/complex.h"

/* What decides which branches stay, one number for each voxel (chessboard
 * metric, in voxels; 0 in matter). NULL: none stays that is not part of a loop
 * or needed to hold the void together (the ultimate skeleton). */
struct collapse_maps {
    const uint16_t *distance; /* to the nearest matter */
    const uint16_t *opening;  /* of the largest cube of void around it */
    const atomic_int *stop;   /* non-zero: leave off; NULL: never */
};

/* Removes cells until only curves and points are left. Keeps what collapses
 * keep: the number of parts, tunnels and hollows, so the Euler characteristic.
 * `voxels` is what the complex was made of. Returns the number of layers
 * removed. */
int complex_collapse(struct complex *complex, const struct voxels *voxels,
                     const struct collapse_maps *maps);

#endif
