/* Light of lamps on what a gather ray meets. */
#ifndef LIGHTMESH_GATHER_LAMPS_H
#define LIGHTMESH_GATHER_LAMPS_H

#include <stdbool.h>

#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather.h"

/* A place within a cell of the mesh, around its middle. */
vec3 gather_jitter(const struct draws *draws);

/* Whether mesh points are asked for lamps, as they hold their sum or these are
 * too many to draw one of. */
bool gather_lamps_asks(const struct direct_mesh *direct);

/* Those that mesh points hold for the picture as well, or else one shadow
 * ray's; of few lamps each one's, unless light scatters `again`. Points are of
 * all surfaces: where lamps are of some alone they don't know. */
rgb gather_lamps(const struct gather *gather, struct worker *worker,
                 const struct draws *draws, bool again,
                 const struct surface *surface,
                 const struct receiver *receiver);

/* The same, not again, on several, if gather->together. */
void gather_lamps_many(const struct gather *gather, struct worker *worker,
                       struct lit_places *places);

#endif
