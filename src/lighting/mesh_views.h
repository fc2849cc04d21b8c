/* What there is to see of light meshes: their known points. */
#ifndef LIGHTING_MESH_VIEWS_H
#define LIGHTING_MESH_VIEWS_H

#include "lighting/show.h"
#include "lightmesh/indirect.h"
#include "lightmesh/pixel_mesh.h"
#include "lightmesh/scalar.h"

/* By the light of lamps that reaches them; `pixels` may be NULL. */
void mesh_show_direct(const struct direct_mesh *mesh,
                      const struct pixel_mesh *pixels, struct show *show);

/* Those of a scalar mesh, by what they hold. */
void mesh_show_scalar(const struct point_mesh *points, struct show *show);

/* By the light of surfaces that reaches them, of the first bounce; `mesh` may
 * be NULL. */
void mesh_show_indirect(const struct indirect_mesh *mesh, struct show *show);

#endif
