/* What lamps give a surface under light meshes: whoever knows it there is asked
 * (lightmesh/knower.h), lamp by lamp or all together. */
#ifndef LIGHTING_MESH_LAMPS_H
#define LIGHTING_MESH_LAMPS_H

#include "lighting/lamplight.h"
#include "lightmesh/knower.h"

struct mesh_lamps {
    const struct knowers *knowers;
    struct lattice_view view;
};

/* Visits the lamps' samples; what has no direction is returned, to be
 * multiplied by the first layer's diffuse share. */
rgb mesh_lamps_light(const struct mesh_lamps *mesh, struct lamplight *light);

#endif
