/* Warps: bends of space between a pattern and what moves it. */
#ifndef SCENE_WARP_H
#define SCENE_WARP_H

#include "base/affine.h"
#include "scene/pattern.h"

enum warp_kind {
    WARP_TURBULENCE,
    WARP_REPEAT,
    WARP_BLACK_HOLE,
    WARP_PLANAR, /* the plane of x and y is laid on a plane, */
    WARP_CYLINDRICAL,
    WARP_SPHERICAL,
    WARP_TOROIDAL,
    WARP_CUBIC, /* a cross of six squares is folded to a cube */
};

struct warp {
    enum warp_kind kind;
    affine inverse;           /* after it: what was moved before it */
    const struct warp *inner; /* then that one, or NULL */
    struct turbulence turbulence;
    vec3 period;       /* repeat: along one axis; black hole: or 0 */
    vec3 offset, flip; /* of each repetition; axes that change sides */
    vec3 centre;       /* of a black hole, and so on: */
    double radius, falloff, strength;
    bool push;        /* outward: inverse */
    vec3 orientation; /* of the last four; z leaves the result as it is */
    double distance;  /* planar: the third coordinate */
    double stretch;   /* the others: so much with the distance, dist_exp */
    double major;     /* toroidal: the radius of the ring */
};

/* The point that all of them make of one. */
vec3 warp_all(const struct warp *warp, vec3 point);
/* The same of several. */
void warps_move(const struct warp *warp, struct spots *spots);

#endif
