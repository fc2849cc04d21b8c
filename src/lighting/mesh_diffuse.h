/* Light without a direction by the indirect light mesh. */
#ifndef LIGHTING_MESH_DIFFUSE_H
#define LIGHTING_MESH_DIFFUSE_H

#include "lighting/lighting.h"
#include "lightmesh/indirect_pixels.h"
#include "shade/facets.h"

/* Who knows it. */
struct mesh_indirect {
    const struct indirect_mesh *mesh;
    const struct indirect_pixels *pixels; /* of this picture, or NULL */
    const struct ambience *ambience;
    struct lattice_view view;
    double worth; /* of indirect light in the picture, as a survey has it */
    bool smooth;  /* of surfaces without bumps */
};

/* Indirect and ambient light on the surface's first layer. */
struct diffuse_light mesh_diffuse(const struct mesh_indirect *known,
                                  struct worker *worker,
                                  const struct surface *surface);

/* On facet number `i`, which must be matt. */
struct diffuse_light mesh_diffuse_facet(const struct mesh_indirect *known,
                                        struct worker *worker,
                                        const struct facets *facets,
                                        unsigned i);

#endif
