/* What rays in the void meet: zones. The walls of pieces are sorted by which of
 * the six ways they face: a piece and a side are a zone. */
#ifndef SKELETON_SIGHT_H
#define SKELETON_SIGHT_H

#include "base/side.h"
#include "skeleton/patches.h"
#include "skeleton/pieces.h"
#include "skeleton/skeleton.h"

#define ZONE_NONE UINT32_MAX       /* a wall that no piece is before */
#define ZONE_SKY  (UINT32_MAX - 1) /* out of the grid */

static inline uint32_t zone_of(uint32_t piece, int side)
{
    return SIDES * piece + (uint32_t)side;
}

struct sight {
    const struct skeleton *skeleton;
    const struct pieces *pieces;
    struct patches_scene scene;
};

/* What a ray meets. */
struct sighting {
    uint32_t zone;
    double distance; /* in the grid */
    rgb beyond;      /* ZONE_SKY: the radiance of what is met out there */
    double clear;    /* share of a zone's light that fog lets through, */
    rgb veil;        /* and the radiance of fog before it */
    /* While walls find what glows: */
    rgb glow; /* radiance of what is met by itself, as it arrives; it is
               * part of `beyond`, too */
    double
        picked;  /* density with which sight_picks finds it, per solid angle */
    bool narrow; /* whether it is a wall that no void is before, ... */
    struct intersection at; /* ... and where, if it is */
};

/* The zone that a ray meets from tmin on; `key` names its random numbers. */
struct sighting sight_zone(const struct sight *sight, const struct ray *ray,
                           double tmin, uint64_t key);

/* The same from 0 on of the first `count` of them, which are quicker together;
 * the other rays are changed. */
void sight_zones(const struct sight *sight, struct rays *rays, unsigned count,
                 const uint64_t *keys, struct sighting *seen);

/* Whether there is anything for sight_picks. */
bool sight_may_pick(const struct sight *sight);

/* Something that glows, picked for a point. */
struct sight_pick {
    vec3 point;
    double which, where[2]; /* numbers in [0,1) by which it is picked */
    vec3 direction;         /* unit, from the point */
    rgb glow;               /* radiance that arrives; 0: nothing is picked, or
                             * something else is in the way */
    double picked;          /* density, as of a sighting */
};

/* Up to RAY_LANES of them, if sight_may_pick: fills in what isn't given. */
void sight_picks(const struct sight *sight, struct sight_pick *picks,
                 unsigned count);

#endif
