/* Area lights: a grid of points, and POV-Ray's own way of averaging over it
 * (section 5.7 of tests/povray.md, measured). */
#ifndef SHADE_AREA_H
#define SHADE_AREA_H

#include <stdint.h>

#include "base/rgb.h"
#include "scene/rays.h"
#include "shade/lamp.h"

/* The grid as one surface point sees it. */
struct area_grid {
    const struct light *light;
    vec3 axis1, axis2; /* turned to the point if the light says orient */
    int size1, size2;  /* points along them */
    int adaptive;      /* as the light's */
    uint64_t key;      /* of the jitter; 0: none */
    double scale[2];   /* from units of the axes to those of the hull */
};

/* `seed` sets the jitter, which differs from point to point but not from run
 * to run. */
struct area_grid area_grid_new(const struct lamp *lamp, vec3 point,
                               uint64_t seed);

/* Steps along a side of a refined grid. */
enum { AREA_FINE = 64 };

/* Makes the grid as fine as area_outline wants it, without jitter. */
void area_grid_refine(struct area_grid *grid);

/* Half the sides of a parallelogram around the light's location that holds all
 * points of the grid. */
void area_grid_hull(const struct area_grid *grid, vec3 half[2]);

/* A point of the whole light that the grid stands for, as `point` sees it, by
 * two numbers in [0,1). Round lights are ellipses with the axes as diameters; a
 * side of one point has no extent. */
vec3 area_anywhere(const struct lamp *lamp, vec3 point, const double u[2]);

/* Point (i, j) of the grid, 0 <= i < size1, 0 <= j < size2. */
vec3 area_grid_point(const struct area_grid *grid, int i, int j);

/* Points of the grid side by side. What is in lanes beyond their number doesn't
 * matter; if there are several, they are numbers. */
struct area_points {
    int count;                          /* 1 to RAY_LANES */
    LANE_LINES double at[2][RAY_LANES]; /* i and j */
    double location[3][RAY_LANES];
    double place[2][RAY_LANES]; /* in that parallelogram, in units of its half
                                 * sides */
};

/* Finds out about so many whose i and j are set. */
void area_grid_points(const struct area_grid *grid, struct area_points *points);

/* What part of the light comes from each of these points. */
typedef void area_visit(void *context, const struct area_points *points,
                        rgb seen[RAY_LANES]);

/* The share of the whole light that is seen: not the mean of the points, but
 * POV-Ray's recursive bisection with weights, adaptive if the light says so:
 * `arriving`, the unshadowed light at the point, tells what differences are
 * small. */
rgb area_visibility(const struct area_grid *grid, rgb arriving,
                    area_visit *visit, void *context);

/* The same for a refined grid, nearer the true share over the light's surface
 * and with fewer points: what hides part of it is taken to have an outline,
 * straight within cells of a few steps (marching squares, Lorensen and Cline
 * 1987, with the outline's places found by bisection); behind panes, where
 * light changes by and by, as many points are asked as the author has written
 * [a box of coloured glass: .55 of the time]. `thorough` if it costs little to
 * look for thin things where the light seems to be seen. */
rgb area_outline(const struct area_grid *grid, rgb arriving, bool thorough,
                 area_visit *visit, void *context);

#endif
