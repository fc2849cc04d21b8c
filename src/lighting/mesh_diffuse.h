/* Light without a direction by the indirect light mesh. */
#ifndef LIGHTING_MESH_DIFFUSE_H
#define LIGHTING_MESH_DIFFUSE_H

#include "lighting/lighting.h"
#include "lightmesh/indirect.h"

/* Indirect and ambient light on the surface's first layer. */
struct diffuse_light mesh_diffuse(const struct indirect_mesh *mesh,
                                  struct lattice_view view,
                                  const struct ambience *ambience,
                                  struct worker *worker,
                                  const struct surface *surface);

#endif
