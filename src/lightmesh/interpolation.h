/* From which mesh points a place takes its light, and how much from each
 * (section 2 of the light-mesh paper). Each kind is one file of interpolation/
 * and one row of its list.h. */
#ifndef LIGHTMESH_INTERPOLATION_H
#define LIGHTMESH_INTERPOLATION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/vec.h"

enum { INTERPOLATION_POINTS = 512 };

/* The widest radius that needs no more points than that, in spacings. */
#define INTERPOLATION_RADIUS_MAX 4.0

/* A lattice point and its share. */
struct mesh_weight {
    int at[3];
    double weight; /* > 0; they need not sum to 1 */
};

struct interpolation {
    const char *name;
    const char *help;
    double radius; /* if none is asked for, in spacings */
    bool single;   /* only the first usable point counts */
    /* The points for a place in units of the spacing, on a surface with that
     * unit normal or a little above it; returns how many. */
    int (*weights)(vec3 place, vec3 normal, double radius,
                   struct mesh_weight out[INTERPOLATION_POINTS]);
};

/* For kinds of `weights`: the radius that serves in place of one that is too
 * small or too large. */
double interpolation_reach(double radius);

/* For kinds of `weights`: the lattice points within a radius, in spacings, of a
 * place, each with weight 1 - d^2/r^2 for its distance d; returns how many. */
int interpolation_ball(vec3 place, double radius,
                       struct mesh_weight out[INTERPOLATION_POINTS]);

/* By name, or NULL; by number, or NULL past the end. The first is the
 * default. */
const struct interpolation *interpolation_find(const char *name);
const struct interpolation *interpolation_at(size_t index);

#endif
