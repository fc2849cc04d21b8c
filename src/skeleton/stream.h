/* How the light of lamps goes along the skeleton: what heuristics share. */
#ifndef SKELETON_STREAM_H
#define SKELETON_STREAM_H

#include "skeleton/skeleton.h"

/* The way of a lamp's light that doesn't come straight. */
struct stream_way {
    double length;   /* from the source to the point, world units */
    double share;    /* of the light that gets so far */
    uint32_t source; /* node where the way began */
    vec3 direction;  /* unit, from the point to where light comes from */
};

/* Finds a heuristic's way to the sources of these paths from a point that they
 * reach. */
typedef struct stream_way stream_follow(const struct skeleton *skeleton,
                                        const struct skeleton_lamp *lamp,
                                        const struct skeleton_point *point);

/* The light of all lamps (an estimate from some, where they are many): of those
 * that the point sees, what they give (A3); of the others what comes by the way
 * that `follow` finds (NULL: nothing). */
struct skeleton_light stream_gather(const struct skeleton *skeleton,
                                    struct worker *worker,
                                    const struct skeleton_point *point,
                                    stream_follow *follow);

/* Whether nothing opaque stands between two points. */
bool stream_sees(const struct skeleton *skeleton, vec3 from, vec3 to);

/* Where the way from a node began. */
uint32_t stream_source(const struct paths *paths, uint32_t node);

/* Where a lamp's light starts along the skeleton: the lamp, or the source. */
vec3 stream_start(const struct skeleton *skeleton,
                  const struct skeleton_lamp *lamp, uint32_t source);

/* The forward heuristic's way: no rays. */
stream_follow stream_forward;

#endif
