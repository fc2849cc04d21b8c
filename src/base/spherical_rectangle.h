/* A rectangle as seen from a point: the solid angle that it fills, and points
 * of it that are uniform over that (Urena, Fajardo and King, "An
 * Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013). */
#ifndef BASE_SPHERICAL_RECTANGLE_H
#define BASE_SPHERICAL_RECTANGLE_H

#include "base/vec.h"

struct spherical_rectangle {
    vec3 from, x, y, z;    /* the point, and axes: two along the sides */
    double x0, x1, y0, y1; /* where the sides are, from the point, */
    double z0;             /* and its plane, < 0 */
    double angle;          /* steradians, 0 from a point in its plane */
    double b0, b1, k;      /* of their formulas */
};

/* Of the corner `at` and sides a and b, which are at right angles. Angles below
 * some 1e-4 are not exact. */
struct spherical_rectangle spherical_rectangle_new(vec3 at, vec3 a, vec3 b,
                                                   vec3 from);

/* The point of it for two numbers in [0,1). Its angle must not be 0. */
vec3 spherical_rectangle_point(const struct spherical_rectangle *seen,
                               const double u[2]);

#endif
