/* Mesh points on surfaces. Section 1.6 of the light-mesh paper leaves open
 * where mesh points are. Those of a lattice in space see what a surface near
 * them sees only if nothing near is small: between leaves the light changes
 * from one to the next, and a point in the air knows of none. Here the sides of
 * boxes and large flat triangles have a lattice of points of their own, and
 * small triangles that stand alone have three points, or one. All of them know
 * only the lamps in front of them, half of all, and see what is there and not
 * what is a step away: shadows begin where things stand, and walls are smooth.
 *
 * A point is named by its piece of surface, the side, how often its edges are
 * halved, and two integers; everything a mesh knows of it is a function of
 * that name alone. */
#ifndef LIGHTMESH_FACET_MESH_H
#define LIGHTMESH_FACET_MESH_H

#include "lightmesh/facet.h"
#include "lightmesh/facet_light.h"
#include "lightmesh/point_mesh.h"

struct facet_mesh {
    struct facets *facets;
    struct facet_lamps *lamps;
    struct point_mesh points; /* what is known; of the lattice only how near
                               * points are to each other */
    int budget;               /* lamps that a leaf's point asks, about */
};

/* `lattice`: how near points are to each other; `bytes` of memory for points.
 * Frees with facet_mesh_free. The lamps and the tree must outlive it. */
struct facet_mesh *facet_mesh_new(const struct lamps *lamps,
                                  const struct light_tree *tree,
                                  const struct lattice *lattice, int budget,
                                  size_t bytes);
void facet_mesh_free(struct facet_mesh *mesh);

/* The light at a surface point. False if it lies on no piece that has mesh
 * points of its own, or none of these sees it. */
bool facet_mesh_light(const struct facet_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      struct facet_light *light);

/* Adds the names of the points that it would ask for; as facet_mesh_light. */
bool facet_mesh_want(const struct facet_mesh *mesh,
                     const struct receiver *receiver, struct distinct *wanted);

#endif
