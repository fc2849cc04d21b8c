/* Virtual lights as a mesh point sees them. */
#ifndef LIGHTMESH_GATHER_VIRTUAL_H
#define LIGHTMESH_GATHER_VIRTUAL_H

#include "lightmesh/gather_glow.h"

/* Of those of a part (virtual_lights.h) the next RAY_LANES from number *next
 * on, by a ray to each. Returns how many the place sees, into found[RAY_LANES]:
 * what a ray there would bring, drawn with that density. */
unsigned gather_virtual(const struct gather *gather, struct worker *worker,
                        vec3 place, unsigned part, int *next,
                        struct gathered_glow *found);

#endif
