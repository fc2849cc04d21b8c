/* What a place gathers itself. In a crevice, as under a ball that lies on a
 * floor, mesh points are no help: those that see a place there are outside of
 * it, and have what it hasn't. */
#ifndef LIGHTMESH_NEAR_OWN_H
#define LIGHTMESH_NEAR_OWN_H

#include "lightmesh/gather.h"

struct indirect_mesh;
struct receiver;
struct worker;

/* What the receiver's side gets, without bumps, and into *light the same before
 * its cosines: by the mesh's `near_own` rays, and by as many picks of what
 * glows, but for what near_glow.h finds. What counts for little, of 1, has one
 * packet of them, which goes all around as well. `known` is what the points
 * around say of the place. */
struct indirect_share near_own_gather(const struct indirect_mesh *mesh,
                                      struct worker *worker,
                                      const struct receiver *receiver,
                                      const struct indirect_light *known,
                                      double counts,
                                      struct indirect_light *light);

#endif
