/* Surfaces under lamps that a direct mesh knows one by one. */
#ifndef LIGHTING_MESH_FEW_H
#define LIGHTING_MESH_FEW_H

#include "lighting/lamplight.h"
#include "lighting/mesh_pixels.h"
#include "lightmesh/direct.h"

/* Who says what of a lamp's light gets to a surface. */
enum mesh_few_way {
    MESH_FEW_BLENDED, /* the mesh points around; of area lights shadow rays,
                       * which make their shadows soft anyway */
    MESH_FEW_SETTLED, /* shadow rays, of lamps on which the points differ */
    MESH_FEW_ASKED,   /* shadow rays. Mesh points do not see what falls between
                       * them, and cost more than those of two dozen lamps */
};

/* Visits the lamps' samples. The mesh must not be of many lamps. What the
 * picture's points know is not asked. */
void mesh_few_give(const struct direct_mesh *mesh, enum mesh_few_way way,
                   const struct mesh_pixels *pixels,
                   const struct lamplight *light);

#endif
