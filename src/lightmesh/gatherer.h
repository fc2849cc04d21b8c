/* What a point of the indirect mesh gathers: the mean of its gather rays. */
#ifndef LIGHTMESH_GATHERER_H
#define LIGHTMESH_GATHERER_H

#include "lightmesh/indirect.h"

/* Into the payload, a struct indirect_light; the context is the mesh
 * (point_mesh in point_mesh.h). All points send as many rays, and some of them
 * more where these differ (way_cells.h): to leave off where they agree would
 * miss what is bright and seldom met. */
void gatherer_fill(const void *context, struct worker *worker,
                   const struct mesh_site *site, void *payload);

/* How many of a point's rays are sent everywhere alike, if it aims others at
 * bright places, or not. */
uint32_t gatherer_everywhere(uint32_t samples, bool aims);

#endif
