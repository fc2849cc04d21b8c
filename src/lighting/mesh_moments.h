/* Light meshes of an animation, smoothed over time. */
#ifndef LIGHTING_MESH_MOMENTS_H
#define LIGHTING_MESH_MOMENTS_H

#include "lighting/lighting.h"
#include "lighting/mesh_state.h"

/* Meshes as those of the picture's own moment have been made, what ends their
 * bounces and what survey and plan found being that one's; light of surfaces is
 * smoothed by all moments whose points are in the same places. Returns false,
 * having done nothing, if there are no moments. */
bool mesh_by_moments(struct mesh_lighting *mesh, const struct scene *scene,
                     const struct lighting_options *options, struct diag *diag);

#endif
