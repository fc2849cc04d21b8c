/* Where most of the light in a chamber comes from: the patch of sun under its
 * window. Gather rays that are sent everywhere alike find it seldom, and walls
 * are blotched; so mesh points send some of theirs to the places that a survey
 * found to be bright (importance sampling; both kinds are weighed by the
 * balance heuristic, Veach 1997, section 9.2, so that no place is counted
 * twice). */
#ifndef LIGHTMESH_BRIGHT_H
#define LIGHTMESH_BRIGHT_H

#include <stddef.h>

#include "base/vec.h"

enum { BRIGHT_MOST = 24 };

/* Balls around cells of a lattice in the world, which stays where it is when
 * the camera moves. */
struct bright {
    int count; /* 0: light comes from everywhere */
    double radius;
    struct {
        vec3 centre;
        double light; /* mean of what comes from there */
    } at[BRIGHT_MOST];
};

/* What one ray of a survey met. */
struct bright_hit {
    vec3 place;
    double light;
};

/* Of so many hits, which come in any order. */
struct bright bright_of(const struct bright_hit *hits, size_t count);

/* The bright places as a mesh point sees them: cones of directions. */
struct aim {
    int count;
    struct {
        vec3 axis;
        double rise;  /* 1 - the cosine of its half angle */
        double share; /* of the directions */
    } cone[BRIGHT_MOST];
    double sums[BRIGHT_MOST]; /* of shares up to there */
};

void aim_take(struct aim *aim, const struct bright *bright, vec3 place);

/* A direction for u in [0,1)^2, and how likely one is, per solid angle. */
vec3 aim_way(const struct aim *aim, const double u[2]);
double aim_density(const struct aim *aim, vec3 way);

#endif
