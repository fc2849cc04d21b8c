/* How wide the void is at each voxel: the radius of the largest ball within
 * the void that holds it, O(p) = max { D(c) : |p - c| < D(c) } in the
 * chessboard distance (granulometry's opening function). */
#ifndef SKELETON_OPENING_H
#define SKELETON_OPENING_H

#include "skeleton/voxels.h"

/* From the map of distance_chessboard, into out[voxels_count(v)]; `out` may be
 * `distance`. Matter has 0. */
void opening_chessboard(const struct voxels *v, const uint16_t *distance,
                        unsigned threads, uint16_t *out);

#endif
