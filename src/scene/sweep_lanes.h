/* Where a ray is in some pieces of a sphere_sweep, side by side. */
#ifndef SCENE_SWEEP_LANES_H
#define SCENE_SWEEP_LANES_H

#include <stddef.h>

#include "base/octet.h"
#include "scene/ray.h"

/* A ball: middle and radius, or how they change. */
struct ball {
    vec3 at;
    double radius;
};

/* What a ball passes that goes straight on and grows evenly: convex. */
struct sweep_lanes {
    double from[4][OCTET]; /* the first ball: x, y, z and radius */
    double axis[4][OCTET]; /* from it to the last */
    double part[OCTET];    /* 1 / (axis^2 - growth^2); 0: one ball holds the
                            * other */
    double first[OCTET];   /* 1: its first ball is no other piece's last */
};

/* Where the ray enters and leaves; near >= far: it misses. */
struct sweep_stretches {
    double near[OCTET], far[OCTET];
};

/* All lanes are to be set. `first` as the member. */
void sweep_lanes_set(struct sweep_lanes *lanes, size_t i,
                     const struct ball *from, const struct ball *to,
                     bool first);

/* Whether the ray meets any of them. */
bool sweep_lanes_meet(const struct sweep_lanes *lanes, const struct ray *ray,
                      struct sweep_stretches *found);

#endif
