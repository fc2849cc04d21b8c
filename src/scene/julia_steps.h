/* Rays through Julia sets of hypercomplex functions, which bend and jump more
 * than a distance can be told of: by equal steps, eight at a time. */
#ifndef SCENE_JULIA_STEPS_H
#define SCENE_JULIA_STEPS_H

#include "scene/julia_fractal.h"

/* Where the ray goes in or out between tmin and tmax, to `visit` until that
 * returns true; `enough`: so near is near enough. A step is `step` of t. */
void julia_steps_visit(const struct julia_fractal *fractal,
                       const struct ray *ray, double tmin, double tmax,
                       double step, double enough, hit_visit *visit,
                       void *context);

#endif
