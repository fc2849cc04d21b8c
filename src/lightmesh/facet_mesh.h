/* Mesh points on surfaces. Section 1.6 of the light-mesh paper leaves open
 * where mesh points are. Those of a lattice in space see what a surface near
 * them sees only if nothing near is small: between leaves the light changes
 * from one to the next, and a point in the air knows of none. Here large flat
 * triangles have a lattice of points of their own, and small ones that stand
 * alone have three points, or one. All of them know only the lamps in front of
 * them, half of all, and need not be asked what hides them from the surface
 * they lie on.
 *
 * A point is named by its triangle, the side, how often the triangle's edges
 * are halved, and two integers; everything a mesh knows of it is a function of
 * that name alone. */
#ifndef LIGHTMESH_FACET_MESH_H
#define LIGHTMESH_FACET_MESH_H

#include "lightmesh/facet.h"
#include "lightmesh/facet_light.h"
#include "lightmesh/point_mesh.h"

struct facet_mesh {
    struct facets *facets;
    struct facet_lamps *lamps;
    struct point_mesh points; /* what is known; the lattice is not used */
    int budget;               /* lamps that a leaf's point asks, about */
};

/* `full` as in struct point_mesh; `bytes` of memory for points. Frees with
 * facet_mesh_free. The lamps, the tree and *full must outlive it. */
struct facet_mesh *facet_mesh_new(const struct lamps *lamps,
                                  const struct light_tree *tree, int budget,
                                  atomic_bool *full, size_t bytes);
void facet_mesh_free(struct facet_mesh *mesh);

/* A surface point that asks. */
struct facet_question {
    const struct lattice *lattice; /* how near points are to each other */
    const struct intersection *at;
    vec3 side; /* the true normal, turned to the lit side */
};

/* The light at a surface point. False if it lies on no triangle that has mesh
 * points of its own, or none of these sees it. */
bool facet_mesh_light(const struct facet_mesh *mesh, struct worker *worker,
                      const struct facet_question *question,
                      struct facet_light *light);

#endif
