/* A way through media, interval by interval, and which places of one are looked
 * at: see media.c. */
#ifndef SHADE_MEDIA_MARCH_H
#define SHADE_MEDIA_MARCH_H

#include "scene/spots.h"
#include "shade/media.h"

/* Less light than this comes through, behind that depth: the rest of a way is
 * not looked at. */
#define MEDIA_DARK 1e-7
#define MEDIA_DEEP 16.12 /* -log(MEDIA_DARK) */

/* The way so far, and the interval that is next. */
struct march {
    const struct media_way *way;
    const struct medium *how; /* the first of the media */
    struct veil veil;
    double from, length;
    bool lit, even; /* even: of no densities, the same all along */
    bool keyed;
    uint64_t key; /* of random numbers, once they are needed */
};

/* At the beginning of a way through some media, which is kept. */
struct march march_begin(const struct media_way *way);

/* How many intervals its media ask for. */
int march_intervals(const struct march *march);

/* Whether it only dims what comes along it, at places that are known from the
 * start: no light is added. */
bool march_dims(const struct march *march);

/* At this share of the interval there is a place to look at. */
static inline void march_place(const struct march *march, struct spots *places,
                               double share)
{
    double t = march->from + share * march->length;
    spots_add(places, vec3_along(march->way->origin, march->way->direction, t));
}

/* The next of the way's random numbers in [0,1). */
double march_random(struct march *march);

/* Method 3: how many ends and beginnings of pieces an interval has, and by how
 * much of a piece all are moved. */
int march_pieces(const struct march *march);
double march_moved(struct march *march);

/* Methods 1 and 2: where in an interval the sample number `i` of those that are
 * always taken is, from 0 to 1. */
double march_share(struct march *march, int i);

/* What is left of light after a length of this depth a unit. */
static inline rgb depth_through(rgb depth, double length)
{
    if (depth.r == depth.g && depth.g == depth.b)
        return rgb_grey(exp(-depth.r * length));
    return (rgb){ exp(-depth.r * length), exp(-depth.g * length),
                  exp(-depth.b * length) };
}

#endif
