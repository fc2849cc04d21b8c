/* julia_fractal: the points of a three-dimensional slice of four dimensions
 * that stay near the origin when a function is applied to them again and again.
 */
#ifndef SCENE_JULIA_FRACTAL_H
#define SCENE_JULIA_FRACTAL_H

#include "scene/julia_function.h"
#include "scene/primitive.h"

enum julia_algebra { JULIA_QUATERNION, JULIA_HYPERCOMPLEX };

enum {
    JULIA_STEPS = 20000,     /* of one ray, at most */
    JULIA_ITERATIONS = 1000, /* at most */
    JULIA_MORE = 4, /* steps beyond what decides: the farther, the surer */
    JULIA_ORBIT = JULIA_ITERATIONS + JULIA_MORE,
};

struct julia_fractal {
    double c[5]; /* what is added after each step; four are used */
    enum julia_algebra algebra;
    const struct julia_function *function; /* of hypercomplex numbers */
    bool cube;                             /* of quaternions */
    bool polynomial;                       /* what is gone goes ever farther */
    bool stepped;    /* not so, and its rays go by equal steps */
    double power[2]; /* of pwr() */
    int iterations;
    double precision;
    double slice[5]; /* normal, and distance from the origin along it */
    /* Made by prepare: */
    double w[4];        /* the fourth number is w . (x, y, z, 1) */
    double stretch;     /* of a way in space on the slice, at most */
    double radius;      /* a number that is larger after a step is gone */
    double least;       /* step of a ray */
    double *potentials; /* after each step, its radius's: see julia_fate.c */
    double *limits;     /* what stays is no larger after each step, JULIA_MORE
                         * beyond the last included */
};

extern const struct primitive julia_fractal_primitive;

void julia_fractal_init(struct julia_fractal *fractal);

#endif
