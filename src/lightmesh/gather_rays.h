/* Gather rays that set out from one place together: where they first meet
 * something is found for all at once, and what lamps give it there. */
#ifndef LIGHTMESH_GATHER_RAYS_H
#define LIGHTMESH_GATHER_RAYS_H

#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather.h"

/* At first `count` is 0. */
struct gather_rays {
    struct rays rays;
    struct draws draws[RAY_LANES];        /* what each of them is sample of */
    struct gathered_ray found[RAY_LANES]; /* at first only where they end */
    unsigned count;
    struct lit_places lit; /* of what they met, what it is known of */
};

/* One more, of which there is room for RAY_LANES; `way` is unit. */
void gather_rays_add(struct gather_rays *sent, const struct draws *draws,
                     vec3 place, vec3 way);

/* Whether lamps may light what number `i` met; and that it is to be known of
 * what they give it, in sent->lit. */
bool gather_rays_may_light(const struct gather_rays *sent, unsigned i);
void gather_rays_want_light(struct gather_rays *sent, unsigned i);

/* What they meet first within that distance. */
void gather_rays_meet(const struct gather *gather, struct worker *worker,
                      double reach, struct gather_rays *sent);

/* The same at any distance, and lit: for many rays that will all be followed.
 */
void gather_rays_trace(const struct gather *gather, struct worker *worker,
                       struct gather_rays *sent);

/* What comes along number `i` of those that were traced, in sent->found. */
const struct gathered_ray *gather_rays_follow(const struct gather *gather,
                                              struct worker *worker,
                                              struct gather_rays *sent,
                                              unsigned i);

#endif
