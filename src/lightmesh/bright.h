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

enum { BRIGHT_MOST = 64 };

/* Balls around cells of lattices in the world, which stay where they are when
 * the camera moves. */
struct bright {
    int count; /* 0: light comes from everywhere */
    struct {
        vec3 centre;
        double radius;
        double light; /* mean of what comes from there */
    } at[BRIGHT_MOST];
};

/* What one ray of a survey met: brightness. */
struct bright_hit {
    vec3 from, place;
    double light;
};

/* Of so many hits, which come in any order. What most of them are around is the
 * chamber; what is beyond shines where its light comes in. */
struct bright bright_of(const struct bright_hit *hits, size_t count);

/* What rays found that were aimed at each place: how many, and the sum. */
struct bright_found {
    double rays[BRIGHT_MOST], light[BRIGHT_MOST];
};

/* Places are as bright as such rays found them: less where something stands
 * before them, and none are left that are never seen. */
void bright_learn(struct bright *bright, const struct bright_found *found);

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

/* A direction for u in [0,1)^2, and how likely one is, per solid angle.
 * *which: the place that it goes to. */
vec3 aim_way(const struct aim *aim, const double u[2], int *which);
double aim_density(const struct aim *aim, vec3 way);

#endif
