/* What the camera sees first at the places of a grid over the picture: for
 * lighting methods that want to know all of it before any of it is lit. */
#ifndef SHADE_FIRST_HITS_H
#define SHADE_FIRST_HITS_H

#include "world/world.h"

/* The grid reaches so far beyond what is wanted of the picture, and a little
 * beyond the picture itself: so what is said of a place is the same for every
 * part of a picture. */
enum { FIRST_HITS_APRON = 17, FIRST_HITS_BEYOND = 4 };

struct first_hits {
    int width, height; /* of the picture, pixels */
    int left, top;     /* pixel of the first place; may be -1 */
    int columns, rows;
    double middle;        /* where in their pixels the places are, both ways */
    struct world_hit *at; /* row by row */
    int apron; /* what is said of a place may depend on what is so near to it:
                * at most FIRST_HITS_APRON, and 0 if on that place alone */
};

static inline struct world_hit *first_hits_at(const struct first_hits *hits,
                                              int x, int y)
{
    size_t row = (size_t)(y - hits->top), column = (size_t)(x - hits->left);
    return &hits->at[row * (size_t)hits->columns + column];
}

/* Where in the picture a place is, as camera_ray has it. */
static inline void first_hits_place(const struct first_hits *hits, int x, int y,
                                    double place[2])
{
    place[0] = (x + hits->middle) / hits->width;
    place[1] = (y + hits->middle) / hits->height;
}

/* A place in the picture. */
struct picture_place {
    double at[2];   /* as camera_ray has it */
    double grid[2]; /* as first_hits_at has it: whole numbers are places of the
                     * grid */
    unsigned long long pixel; /* worker_pixel's, where several are of one; else
                               * 0 */
    const struct first_hits *around; /* what is met there and beside it, as far
                                      * as that is known; or NULL */
};

/* Whether it is looked through, so that what is lit there is behind it. */
static inline bool first_hit_is_clear(const struct world_hit *hit)
{
    return hit->leaf && hit->leaf->look->clear;
}

/* Whether the hit is on that part of that leaf. */
static inline bool first_hit_is_on(const struct world_hit *hit,
                                   const struct leaf *leaf, int part)
{
    return hit->leaf == leaf && hit->hit.part == part;
}

#endif
