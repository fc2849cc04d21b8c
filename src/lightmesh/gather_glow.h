/* What glows is found by gather rays that meet it, and by rays that pick it:
 * each counts by how likely the other is. */
#ifndef LIGHTMESH_GATHER_GLOW_H
#define LIGHTMESH_GATHER_GLOW_H

#include "lightmesh/gather.h"

/* Of what comes along the ray, which was drawn with that density per solid
 * angle, what counts beside gather_pick (balance heuristic, Veach 1997, section
 * 9.2): its first surface's glow only in part. */
rgb gather_balanced(const struct gather *gather, const struct ray *ray,
                    double density, const struct gathered_ray *found);

/* The same without the glow of what gather_pick finds: it is no surprise. */
rgb gather_unpicked(const struct gather *gather, const struct ray *ray,
                    const struct gathered_ray *found);

/* A place that glows. */
struct gathered_glow {
    vec3 direction;
    rgb light;
    double density; /* of being picked, per solid angle */
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
