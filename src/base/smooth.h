/* From 0 to 1 without an edge at either end. */
#ifndef BASE_SMOOTH_H
#define BASE_SMOOTH_H

/* 0 below 0, 1 above 1, 3 t^2 - 2 t^3 between: no slope at 0 and 1. */
static inline double smooth_step(double t)
{
    if (t <= 0)
        return 0;
    return t >= 1 ? 1 : t * t * (3 - 2 * t);
}

#endif
