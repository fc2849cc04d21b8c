/* The light mesh's light of surfaces alone, for another method. */
#ifndef LIGHTING_MESH_BOUNCED_H
#define LIGHTING_MESH_BOUNCED_H

#include "lighting/lighting.h"

extern const struct lighting mesh_lighting;

/* Irradiance by light of surfaces: `state` is of mesh_lighting. `smooth`: as if
 * the surface had no bumps. */
rgb mesh_bounced(const void *state, struct worker *worker,
                 const struct surface *surface, bool smooth);

#endif
