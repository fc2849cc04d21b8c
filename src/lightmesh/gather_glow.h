/* What glows is found by gather rays that meet it, and by rays that pick it:
 * each counts by how likely the other is. */
#ifndef LIGHTMESH_GATHER_GLOW_H
#define LIGHTMESH_GATHER_GLOW_H

#include "lightmesh/gather.h"

/* Of what comes along the ray, which was drawn with that density per solid
 * angle, what counts beside gather_pick (balance heuristic, Veach 1997, section
 * 9.2): of its first surface's glow only so much as is `left` to be found, and
 * of that a part. */
rgb gather_balanced(const struct gather *gather, const struct ray *ray,
                    double density, double left,
                    const struct gathered_ray *found);

/* What glows where the ray ends. */
rgb gather_glow_at(const struct gather *gather, const struct ray *ray,
                   const struct intersection *at);

/* A place that glows. */
struct gathered_glow {
    vec3 direction;
    rgb light;
    double density;          /* of being picked, per solid angle */
    const struct leaf *leaf; /* what it is of, */
    double distance;         /* and how far off */
};

/* Such places as seen from one, picked as `count` samples, up to RAY_LANES, of
 * which there must be any (emitters_any). Returns how many there are into
 * *found: before others stands something. */
unsigned gather_pick(const struct gather *gather, struct worker *worker,
                     vec3 place, const struct draws *draws, unsigned count,
                     struct gathered_glow *found);

/* What is picked of what glows, as irradiance of the surface. */
rgb gather_picked(const struct gather *gather, struct worker *worker,
                  const struct surface *surface, const struct draws *draws);

#endif
