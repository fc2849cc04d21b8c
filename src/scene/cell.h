/* A box of space as a shape sees it from its own: turned, stretched, sheared.
 * Shapes tell whether a cell may meet their surface: what voxels need. */
#ifndef SCENE_CELL_H
#define SCENE_CELL_H

#include "base/affine.h"

/* The points centre + a side[0] + b side[1] + c side[2], where |a|, |b|, |c|
 * are at most 1. */
struct cell {
    vec3 centre, side[3];
    vec3 half;     /* of the axis-aligned box around it */
    double radius; /* of the sphere around it */
};

/* What a cell may meet. */
enum {
    CELL_SURFACE = 1,
    CELL_BORDER = 2, /* of the inside: not all of it is seen (open cylinders) */
};

struct range {
    double low, high;
};

/* The box as a cell, its sides along the axes. */
struct cell cell_from_box(vec3 centre, vec3 half);
struct cell cell_moved(const struct cell *cell, const affine *transform);
struct box3 cell_box(const struct cell *cell);
vec3 cell_corner(const struct cell *cell, int i); /* 0..7 */

/* How far the cell reaches from its centre along n, times |n|. */
static inline double cell_reach(const struct cell *cell, vec3 n)
{
    return fabs(vec3_dot(n, cell->side[0])) + fabs(vec3_dot(n, cell->side[1])) +
           fabs(vec3_dot(n, cell->side[2]));
}

/* Distances of the cell's points from `point`: of the nearest, never too large,
 * and of the farthest. */
double cell_nearest(const struct cell *cell, vec3 point);
double cell_farthest(const struct cell *cell, vec3 point);

/* Whether some point of the cell may be in the box; exact but for edges that
 * pass each other. */
bool cell_meets_box(const struct cell *cell, struct box3 box);

/* Whether the triangle meets the axis-aligned box around the cell. */
bool cell_meets_triangle(const struct cell *cell, vec3 a, vec3 b, vec3 c);

#endif
