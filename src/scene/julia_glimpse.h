/* One ray through a Julia set that stands for a cone (primitive.h's
 * first_roughly): eight places along it at a time, where julia_march.h has
 * eight rays. */
#ifndef SCENE_JULIA_GLIMPSE_H
#define SCENE_JULIA_GLIMPSE_H

#include "scene/julia_fractal.h"

struct julia_cone {
    const struct ray *ray;
    double tmin, tmax, spread;
    bool any; /* where it is met doesn't matter */
};

/* Where the ray first goes in or out; HUGE_VAL: nowhere. Of sets of which
 * distances are known. */
double julia_glimpse(const struct julia_fractal *fractal,
                     const struct julia_cone *cone);

#endif
