/* Surfaces under lamps that a direct mesh knows one by one. */
#ifndef LIGHTING_MESH_FEW_H
#define LIGHTING_MESH_FEW_H

#include "lighting/lamplight.h"
#include "lightmesh/direct.h"

/* Who says what of a lamp's light gets to a surface. */
enum mesh_few_way {
    MESH_FEW_BLENDED, /* the mesh points around; of area lights shadow rays
                       * where little stands between, or these differ much */
    MESH_FEW_SETTLED, /* shadow rays, of all lamps on which they differ */
    MESH_FEW_ASKED,   /* shadow rays; of area lights as MESH_FEW_BLENDED. Mesh
                       * points do not see what falls between them, and cost
                       * more than two dozen shadow rays */
};

/* Visits the lamps' samples. The mesh must not be of many lamps. */
void mesh_few_give(const struct direct_mesh *mesh, enum mesh_few_way way,
                   const struct lamplight *light);

#endif
