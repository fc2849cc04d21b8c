/* Where a point is between the planes of the integer lattice, and what the
 * corners of its cell weigh: for every noise on a lattice. */
#ifndef SCENE_NOISE_CELL_H
#define SCENE_NOISE_CELL_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* The lattice plane below a coordinate. Far beyond 2^40 a coordinate has no
 * fraction left and any number does. */
static inline int64_t plane_below(double *coordinate)
{
    double c = *coordinate;
    if (!(fabs(c) < 0x1p40))
        *coordinate = c = isfinite(c) ? fmod(c, 0x1p40) : 0;
    int64_t low = (int64_t)c;
    return low - (c < (double)low);
}

/* From 0 at one plane to 1 at the next, level at both. */
static inline float plane_blend(float t)
{
    return t * t * (3 - 2 * t);
}

/* Of the corner on the upper planes where these are said. */
static inline float corner_weight(const float blend[3], bool x, bool y, bool z)
{
    return (x ? blend[0] : 1 - blend[0]) * (y ? blend[1] : 1 - blend[1]) *
           (z ? blend[2] : 1 - blend[2]);
}

#endif
