/* How the light of lamps comes into the void, and the ways along the skeleton
 * from there. */
#ifndef SKELETON_ENTRANCE_H
#define SKELETON_ENTRANCE_H

#include "skeleton/skeleton.h"

/* Fills plain_lamps and lamps of a skeleton that has its graph, with paths if
 * the heuristic asks for ways. Where there would be more paths than 64 MB hold,
 * lamps share those of others near by (or, from outside, from about the same
 * direction). */
void skeleton_light_up(struct skeleton *skeleton);

#endif
