/* The box around what planes leave of space: gems and prisms made of planes
 * are bounded, though none of their sides is. */
#ifndef WORLD_HALFSPACE_H
#define WORLD_HALFSPACE_H

#include "base/affine.h"

enum { HALFSPACES_MAX = 40 };

/* The points p with normal.p <= distance; the normal is unit. */
struct halfspace {
    vec3 normal;
    double distance;
};

/* The box around the points of `region` that are in all half spaces; or, if it
 * is not finite, `region` itself. At most HALFSPACES_MAX. */
struct box3 halfspaces_box(const struct halfspace *halfspaces, int count,
                           struct box3 region);

#endif
