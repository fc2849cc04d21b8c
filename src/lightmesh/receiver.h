/* Who asks for light: a point of a surface. */
#ifndef LIGHTMESH_RECEIVER_H
#define LIGHTMESH_RECEIVER_H

#include "lightmesh/lattice.h"
#include "lightmesh/tuning.h"
#include "world/world.h"

struct picture_place;

struct receiver {
    vec3 point;
    vec3 side;   /* the true normal there, unit, to the side that is lit */
    vec3 smooth; /* the same as neighbours share it, for ambient light, */
    vec3 normal; /* and with bumps: cosines of all other light are to that */
    vec3 from;   /* where it is seen from: nothing is between */
    const struct intersection *at; /* what it is on; NULL: it isn't told, and
                                    * no points on surfaces are asked */
    const struct picture_place *pixel; /* where the camera sees it at first
                                        * sight; else NULL */
    bool at_first;            /* it does, or a corner asks for what it sees */
    bool unmirrored;          /* it sees it there, or through panes */
    struct lattice_view view; /* how near to each other mesh points are */
    bool far_side;            /* of what lets light through, as a leaf */
    double weight; /* of what it gets in the picture, 0 to 1: what is worth
                    * little is less exact */
};

/* Bumps take what comes from their own sides. */
static inline bool receiver_is_bumpy(const struct receiver *receiver)
{
    return vec3_dot(receiver->normal, receiver->side) < indirect_pixels_flat;
}

/* The side that is seen. */
static inline vec3 receiver_seen(const struct receiver *receiver)
{
    return receiver->far_side ? vec3_negate(receiver->side) : receiver->side;
}

#endif
