/* All crossings of a ray with a mesh, in double precision and each exactly
 * once, as CSG and the inside test need them. (What is only to be seen goes to
 * Embree as it is.) A tree of boxes over one mesh, in the mesh's space. */
#ifndef WORLD_MESH_TREE_H
#define WORLD_MESH_TREE_H

#include "scene/cell.h"
#include "scene/mesh.h"

struct mesh_tree;

/* In `arena`; the mesh must outlive it. */
const struct mesh_tree *mesh_tree_new(struct arena *arena,
                                      const struct mesh *mesh);

/* Calls visit for the crossings with t in (tmin, tmax), in no order. */
void mesh_tree_crossings(const struct mesh_tree *tree, const struct ray *ray,
                         double tmin, double tmax, hit_visit *visit,
                         void *context);

/* Whether a triangle meets the axis-aligned box around the cell. */
bool mesh_tree_meets(const struct mesh_tree *tree, const struct cell *cell);

/* Whether a ray from the point along the mesh's inside_vector crosses it an
 * odd number of times. False if it has none. */
bool mesh_tree_inside(const struct mesh_tree *tree, vec3 point);

#endif
