/* What becomes of a point of space under a julia_fractal's steps. */
#ifndef SCENE_JULIA_ORBIT_H
#define SCENE_JULIA_ORBIT_H

#include "scene/julia_fractal.h"

/* A number of four parts. */
struct quad {
    double x, y, z, w;
};

struct julia_orbit {
    struct quad at[JULIA_ORBIT]; /* the point and where it went */
    double size[JULIA_ORBIT];    /* of these */
    int count;                   /* of steps */
    int away; /* the first that is larger than the limit; of one that stays,
               * count */
    bool gone;
};

/* Follows the point. */
void julia_orbit_follow(const struct julia_fractal *fractal, vec3 point,
                        struct julia_orbit *orbit);

/* Whether the point is gone, once. */
bool julia_orbit_gone(const struct julia_fractal *fractal, vec3 point);

/* All points up to this distance from it fare as it does. A lower bound; 0 if
 * none of `useful` or more is found. */
double julia_orbit_reach(const struct julia_fractal *fractal,
                         const struct julia_orbit *orbit, double useful);

/* The direction in which points of the slice go away sooner. */
vec3 julia_orbit_slope(const struct julia_fractal *fractal, vec3 point);

#endif
