/* Flat pieces of surface that may have mesh points of their own: triangles and
 * the sides of boxes. The many small triangles of a smooth shape should not:
 * neighbours share what the lattice in space knows, and no one sees where one
 * ends; but those that stand alone, as leaves do. */
#ifndef LIGHTMESH_FACET_H
#define LIGHTMESH_FACET_H

#include "world/world.h"

struct facets;

/* A triangle in the world; or a parallelogram, which is the part of one twice
 * as large around its corner 0 where neither share is above 1/2. */
struct facet {
    bool square; /* a parallelogram */
    vec3 corner[3];
    vec3 normal;     /* unit */
    double size;     /* square root of its area */
    double longest;  /* edge */
    int apex;        /* the corner opposite the shortest edge */
    uint32_t number; /* among all pieces of the world */
    bool alone;      /* no other triangle has one of its corners */
};

/* Frees with facets_free. The world must outlive it. */
struct facets *facets_new(const struct world *world);
void facets_free(struct facets *facets);

/* The piece that a ray met; false if it is no flat one. */
bool facets_find(const struct facets *facets, const struct intersection *at,
                 struct facet *facet);

/* The flat piece of this number; false if there is none. */
bool facets_at(const struct facets *facets, uint32_t number,
               struct facet *facet);

/* The place that is `u` of the way to corner 1 and `v` of that to corner 2. */
vec3 facet_place(const struct facet *facet, double u, double v);

/* Its reverse for a place in the plane, taken into the piece: u, v and u + v
 * are in [0,1], of a parallelogram u and v in [0,1/2]. */
void facet_locate(const struct facet *facet, vec3 place, double *u, double *v);

#endif
