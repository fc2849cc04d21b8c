/* Surfaces under lamps that a direct mesh knows one by one. */
#ifndef LIGHTING_MESH_FEW_H
#define LIGHTING_MESH_FEW_H

#include "lighting/lamplight.h"
#include "lighting/mesh_pixels.h"
#include "lightmesh/plan.h"

/* Visits the lamps' samples. The mesh must not be of many lamps. What the
 * picture's points know is not asked. */
void mesh_few_give(const struct direct_mesh *mesh, struct lattice_view view,
                   enum plan_lamps way, const struct mesh_pixels *pixels,
                   const struct lamplight *light);

#endif
