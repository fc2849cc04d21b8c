/* Gather rays that set out from one place together: where they first meet
 * something is found for all at once. */
#ifndef LIGHTMESH_GATHER_RAYS_H
#define LIGHTMESH_GATHER_RAYS_H

#include "lightmesh/gather.h"

/* At first `count` is 0. */
struct gather_rays {
    struct rays rays;
    struct draws draws[RAY_LANES]; /* what each of them is sample of */
    struct world_hit hits[RAY_LANES];
    unsigned count;
};

/* One more, of which there is room for RAY_LANES; `way` is unit. */
void gather_rays_add(struct gather_rays *sent, const struct draws *draws,
                     vec3 place, vec3 way);

/* What they meet within that distance, into hits; leaf NULL: nothing. */
void gather_rays_trace(const struct gather *gather, struct worker *worker,
                       double reach, struct gather_rays *sent);

/* What comes along number `i` of those that were traced. */
void gather_rays_follow(const struct gather *gather, struct worker *worker,
                        const struct gather_rays *sent, unsigned i,
                        struct gathered_ray *found);

#endif
