/* How far the matter is from each voxel of the void, in voxels from centre to
 * centre; matter has 0, the first void voxel 1. */
#ifndef SKELETON_DISTANCE_H
#define SKELETON_DISTANCE_H

#include "skeleton/voxels.h"

/* What lies outside of the grid. Void, if the border is no wall: the distances
 * there are to matter inside. */
enum outside { OUTSIDE_VOID, OUTSIDE_MATTER };

/* There is no matter at all. */
#define DISTANCE_NONE INT32_MAX

/* The exact square of the Euclidean distance, into out[voxels_count(v)]; the
 * caller's. DISTANCE_NONE where nothing is matter. */
void distance_squared(const struct voxels *v, enum outside outside,
                      unsigned threads, int32_t *out);

/* The chessboard distance (of 26 neighbours), as many steps as a king in space
 * needs, into out[voxels_count(v)]. Without any matter, the longest side. */
void distance_chessboard(const struct voxels *v, enum outside outside,
                         uint16_t *out);

#endif
