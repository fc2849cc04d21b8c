/* Virtual lights as a mesh point sees them. */
#ifndef LIGHTMESH_GATHER_VIRTUAL_H
#define LIGHTMESH_GATHER_VIRTUAL_H

#include "lightmesh/gather_glow.h"
#include "lightmesh/virtual_lights.h"

/* By a ray to each of gather->picks that are picked of a part
 * (virtual_lights.h). Returns how many the place sees, into
 * found[VIRTUAL_PICKS_MOST]: what a ray there would bring, drawn with that
 * density. */
unsigned gather_virtual(const struct gather *gather, struct worker *worker,
                        vec3 place, unsigned part, struct gathered_glow *found);

/* How much of lamps' light they bring of what a gather ray, whose unit
 * direction that is, met first: 0 to 1. */
double gather_virtual_share(const struct gather *gather,
                            const struct intersection *at, vec3 way);

#endif
