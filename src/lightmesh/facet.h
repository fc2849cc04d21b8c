/* Triangles that have mesh points of their own: flat ones, large enough for
 * it, that either stand alone, as leaves do, or are several mesh points wide.
 * The many small triangles of a smooth shape are none: neighbours share what
 * the lattice in space knows, and no one sees where one ends. */
#ifndef LIGHTMESH_FACET_H
#define LIGHTMESH_FACET_H

#include "embree/world.h"

struct facets;

/* A triangle in the world. */
struct facet {
    vec3 corner[3];
    vec3 normal;     /* unit */
    double size;     /* square root of its area */
    double longest;  /* edge */
    int apex;        /* the corner opposite the shortest edge */
    uint32_t number; /* among all triangles of the world */
    bool alone;      /* no other triangle has one of its corners */
};

/* Frees with facets_free. The world must outlive it. */
struct facets *facets_new(const struct world *world);
void facets_free(struct facets *facets);

/* The triangle that a ray met; false if it is no flat one. */
bool facets_find(const struct facets *facets, const struct intersection *at,
                 struct facet *facet);

/* The flat triangle of this number; false if there is none. */
bool facets_at(const struct facets *facets, uint32_t number,
               struct facet *facet);

/* The place that is `u` of the way to corner 1 and `v` of that to corner 2. */
vec3 facet_place(const struct facet *facet, double u, double v);

/* Its reverse for a place in the plane, taken into the triangle: u, v and u + v
 * are in [0,1]. */
void facet_locate(const struct facet *facet, vec3 place, double *u, double *v);

#endif
