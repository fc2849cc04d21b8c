/* Whether a mesh point sees the place of a surface that looks for points. */
#ifndef LIGHTMESH_SEEK_SIGHT_H
#define LIGHTMESH_SEEK_SIGHT_H

#include "lightmesh/obstacles.h"
#include "lightmesh/point_mesh.h"

/* As far as what is around the point, which is at `from`, can tell; */
enum sight seek_sight(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct lattice_point *point, vec3 from);

/* where it can't, by a ray; */
bool seek_looks(const struct point_mesh *mesh, struct worker *worker,
                const struct receiver *receiver, vec3 from);

/* and by both. */
bool seek_sees(const struct point_mesh *mesh, struct worker *worker,
               const struct receiver *receiver,
               const struct lattice_point *point, vec3 from);

/* As seek_looks, by a ray that panes don't stop; *through is what they let pass
 * of the light. */
bool seek_looks_through(const struct point_mesh *mesh, struct worker *worker,
                        const struct receiver *receiver, vec3 from,
                        rgb *through);

/* The same, but that only those don't stop it out of which it comes as it was:
 * of a body that the place is in, and that doesn't bend light. */
bool seek_looks_out(const struct point_mesh *mesh, struct worker *worker,
                    const struct receiver *receiver, vec3 from, rgb *through);

#endif
