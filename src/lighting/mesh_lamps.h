/* What lamps give a surface under light meshes: whoever knows it there is asked
 * (lightmesh/knower.h), lamp by lamp or all together. */
#ifndef LIGHTING_MESH_LAMPS_H
#define LIGHTING_MESH_LAMPS_H

#include "lighting/lamplights.h"
#include "lightmesh/knower.h"

struct mesh_lamps {
    const struct knowers *knowers;
    struct lattice_view view;
};

/* Visits the lamps' samples; what has no direction is returned, to be
 * multiplied by the first layer's diffuse share. */
rgb mesh_lamps_light(const struct mesh_lamps *mesh, struct lamplight *light);

/* Whether lamps are asked one by one, so that several surfaces may ask each of
 * them together: mesh_lamps_light_many adds the same to each. */
bool mesh_lamps_may_mix(const struct mesh_lamps *mesh);
void mesh_lamps_light_many(const struct mesh_lamps *mesh, struct worker *worker,
                           struct facets *facets);

#endif
