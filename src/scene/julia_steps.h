/* Rays through Julia sets of hypercomplex functions, which bend and jump more
 * than a distance can be told of: by equal steps, eight at a time. */
#ifndef SCENE_JULIA_STEPS_H
#define SCENE_JULIA_STEPS_H

#include "scene/julia_fractal.h"

/* The part of a ray that is walked. */
struct julia_walk {
    const struct ray *ray;
    double tmin, tmax;
    bool rough; /* between which steps it crosses is near enough */
};

/* Where the ray goes in or out on the way, to `visit` until that returns true.
 */
void julia_steps_visit(const struct julia_fractal *fractal,
                       const struct julia_walk *walk, hit_visit *visit,
                       void *context);

#endif
