/* A mesh point on a triangle: its name, where it is, and how points beside each
 * other differ. */
#ifndef LIGHTMESH_FACET_POINT_H
#define LIGHTMESH_FACET_POINT_H

#include <stdint.h>

#include "lightmesh/facet.h"

enum facet_kind {
    FACET_NONE, /* has no points of its own */
    FACET_SINGLE,
    FACET_CHAIN, /* points from the shortest edge to the opposite corner */
    FACET_CELLS, /* points where the edges are halved again and again */
};

/* A mesh point on a triangle. Its numbers i, j count from corner 0 to 1 and to
 * 2, in a chain from the apex; 2^division are an edge. */
struct facet_point {
    uint32_t triangle;
    bool back;
    enum facet_kind kind;
    int division, i, j;
};

/* All of it in one number, and back. */
uint64_t facet_point_key(const struct facet_point *point);
struct facet_point facet_point_named(uint64_t key);

/* 0 to 1: where a point's samples begin, so that those of a cell complete each
 * other. */
double facet_point_dither(const struct facet_point *point);

/* Where a point is: in the middle of a triangle *wide times as large as the
 * facet, in which its rays begin, and which lies within it. */
vec3 facet_point_place(const struct facet *facet,
                       const struct facet_point *point, double *wide);

#endif
