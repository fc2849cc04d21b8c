/* From one value to another without a step. */
#ifndef BASE_SMOOTH_H
#define BASE_SMOOTH_H

#include <math.h>

/* 0 below 0, 1 above 1, 3 t^2 - 2 t^3 between: no slope at 0 and 1. */
static inline double smooth_step(double t)
{
    if (t <= 0)
        return 0;
    return t >= 1 ? 1 : t * t * (3 - 2 * t);
}

/* 1 up to `whole` < 1, 0 from 1 on, a line between. */
static inline double fade_out(double x, double whole)
{
    return fmin(fmax(1 - (x - whole) / (1 - whole), 0), 1);
}

#endif
