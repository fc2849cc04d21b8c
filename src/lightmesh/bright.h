/* Where most of the light in a chamber comes from: the patch of sun under its
 * window, and the window. Gather rays that are sent everywhere alike find it
 * seldom, and walls are blotched; so mesh points send some more to the places
 * that a survey found to be bright (importance sampling; both kinds are weighed
 * by the balance heuristic, Veach 1997, section 9.2, so that no place is
 * counted twice). What is outside of the chamber is aimed at where its light
 * comes in. */
#ifndef LIGHTMESH_BRIGHT_H
#define LIGHTMESH_BRIGHT_H

#include "base/clones.h"
#include "lightmesh/hit_cells.h"

enum { BRIGHT_MOST = 64 };

/* Discs in cells (hit_cells.h). */
struct bright {
    int count; /* 0: light comes from everywhere */
    double radius;
    struct bright_disc {
        vec3 centre;
        vec3 normal;  /* unit, along an axis, to where its light goes */
        double worth; /* of being aimed at, up to 1: in an animation discs come
                       * and go by and by */
        double brought; /* of lit cells: share of what lamps' light brings */
    } at[BRIGHT_MOST];
};

/* Of so many hits, which come in any order. */
struct bright bright_of(const struct bright_hit *hits, size_t count);

/* The side of their cells. */
double bright_side(const struct bright *bright);

/* By how much light is more than the least that counts, 0 to 1. */
double bright_beyond(double light, double least);

/* Discs side by side, for aim_density. */
struct aim_lanes {
    LANE_LINES double offset[3][BRIGHT_MOST];
    double against[3][BRIGHT_MOST]; /* the normal's opposite */
    double height[BRIGHT_MOST];     /* of the point above the disc's plane */
    double beside[BRIGHT_MOST];     /* squared distance of the middle, less that
                                     * of the rim from it */
    double rays[BRIGHT_MOST];       /* per area, times the squared height */
};

/* The bright places as a mesh point sees them. */
struct aim {
    int count;
    double radius;
    double rays; /* of all discs */
    struct aim_lanes lanes;
    struct aim_disc {
        vec3 offset, normal; /* from the mesh point */
        double rays;         /* that it is worth: the last may count in part, so
                              * that what is worth a little more brings nearly
                              * the same */
        uint64_t key;        /* whose directions this names: always the same */
    } disc[BRIGHT_MOST];
};

enum { AIM_RAYS_MOST = 128 }; /* to one disc */

/* With about so many rays in all. */
void aim_take(struct aim *aim, const struct bright *bright, vec3 place,
              uint32_t rays);

/* The direction to a place on one of the discs for u in [0,1)^2. */
vec3 aim_way(const struct aim *aim, const struct aim_disc *disc,
             const double u[2]);

/* How many rays go into a direction (unit), per solid angle. */
double aim_density(const struct aim *aim, vec3 way);

#endif
