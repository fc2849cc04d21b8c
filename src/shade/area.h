/* Area lights: a grid of points, and POV-Ray's own way of averaging over it
 * (section 5.7 of notes/povray.md, measured). */
#ifndef SHADE_AREA_H
#define SHADE_AREA_H

#include <stdint.h>

#include "base/rgb.h"
#include "shade/lamp.h"

/* The grid as one surface point sees it. */
struct area_grid {
    const struct light *light;
    vec3 axis1, axis2; /* turned to the point if the light says orient */
    int size1, size2;  /* points along them */
    int adaptive;      /* as the light's */
    uint64_t key;      /* of the jitter; 0: none */
};

/* `seed` sets the jitter, which differs from point to point but not from run
 * to run. */
struct area_grid area_grid_new(const struct lamp *lamp, vec3 point,
                               uint64_t seed);

/* Makes the grid about twice as fine, so that its mean comes near the true one
 * over the light's surface: POV-Ray's bisection then gives each point the
 * light around it. Adaptive, whatever the light says. */
void area_grid_refine(struct area_grid *grid);

/* Point (i, j) of the grid, 0 <= i < size1, 0 <= j < size2. */
vec3 area_grid_point(const struct area_grid *grid, int i, int j);

/* What part of the light comes from a point of the grid. */
typedef rgb area_visit(void *context, vec3 location);

/* The share of the whole light that is seen: not the mean of the points, but
 * POV-Ray's recursive bisection with weights, adaptive if the light says so:
 * `arriving`, the unshadowed light at the point, tells what differences are
 * small. */
rgb area_visibility(const struct area_grid *grid, rgb arriving,
                    area_visit *visit, void *context);

#endif
