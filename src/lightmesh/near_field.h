/* What stands close to a place: mesh points, which are some way off, see past
 * it. A few short rays from the place itself say how much light differs there
 * from what the points around know, so that a ball has its shade where it
 * stands on a table. */
#ifndef LIGHTMESH_NEAR_FIELD_H
#define LIGHTMESH_NEAR_FIELD_H

#include <stdint.h>

#include "lightmesh/indirect_light.h"

struct indirect_mesh;
struct receiver;
struct worker;

/* So many rays of a place; of several sets of directions which. */
struct near_rays {
    int count;
    uint32_t set;
};

/* What the receiver gets of *light, a blend of the mesh's points, which is
 * mended as well; the share is that of its side, without bumps. What glows is
 * left as it was: mesh points pick it. Where half of the rays meet nothing the
 * others are spared. */
struct indirect_share near_field_share(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       struct near_rays rays,
                                       struct indirect_light *light);

#endif
