/* The colour spaces of FLIP: see opponent.c. */
#ifndef COMPARE_OPPONENT_H
#define COMPARE_OPPONENT_H

#include "base/vec.h"

/* Linear light of sRGB's primaries to Y_y, C_x, C_z, in which the eye's three
 * channels are blurred. */
vec3 opponent_from_light(vec3 light);

/* Back, cut to 0..1. */
vec3 opponent_to_light(vec3 opponent);

/* Linear light to CIE L*a*b* after Hunt's adjustment: a* and b* count less in
 * the dark. */
vec3 opponent_lab(vec3 light);

#endif
