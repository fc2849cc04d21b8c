/* A ray of the recursive tracer on its way, to whom its light goes, and its
 * place among others: shared by the tracer's files. */
#ifndef TRACER_BRANCH_H
#define TRACER_BRANCH_H

#include "tracer/crossing.h"
#include "tracer/tracer.h"

struct wavefront;

/* Light that a ray gets by way of another, which may still be on its way. What
 * comes after it in the ray's sum waits behind it: the order of a sum is part
 * of the picture. */
struct due {
    struct due *next;
    struct path *to;
    bool known;
    rgb light; /* of `to`'s radiance, once it is known */
    /* The other's light is raised to 1 / exponent, and multiplied by these. */
    rgb tint, share;
    double exponent;
};

/* A ray on its way, and what it has gathered. */
struct path {
    const struct tracer *tracer;
    struct worker *worker;
    struct wavefront *wavefront;
    struct ray ray;
    enum ray_kind kind;
    int level;     /* 1 for camera rays */
    int surfaces;  /* met so far */
    double weight; /* in the pixel, for adc_bailout */
    bool straight; /* the camera's line of sight: its opacity counts */
    bool ended;    /* gathers nothing more but its dues */
    const struct picture_place *place; /* of a camera ray that has met nothing
                                        * yet, but for what is clear; else NULL
                                        */

    rgb share;      /* of what the ray meets next, in its radiance */
    double clear;   /* 1 - opacity so far */
    rgb light;      /* gathered, before the dues */
    double opacity; /* once it has ended */

    struct due *dues, *last; /* in order; NULL: there are none */
    struct due *due;         /* that this one settles; NULL: it is a camera's */
    struct radiance *seen;   /* where a camera's goes */
    struct path *next;       /* in a list of the wavefront */
    struct interiors inside; /* last: mostly little of it is in use */
};

/* It has met a leaf, and what is behind is no more at first sight, unless that
 * is clear. */
static inline void path_passes(struct path *path, const struct leaf *leaf)
{
    if (!leaf->look->clear)
        path->place = NULL;
}

/* A camera ray, which is there and a wavefront's root, sets out; `place` may be
 * NULL. */
void path_start(struct path *path, const struct picture_place *place);

/* What it meets next: false if nothing. */
bool path_meet(struct path *path, struct intersection *at);

/* Through all that the air is full of, so far (INFINITY: to the end), where
 * `end` is met, or NULL; `fog` is what fogs on the way are like, or NULL if
 * that is yet to be found out. */
void path_air(struct path *path, double distance, const struct leaf *end,
              const struct veil *fog);

/* The same, and to the surface that it meets, or, where `sky` is not NULL, to
 * what it sees of that: false if the ray ends there. */
bool path_arrive(struct path *path, struct crossing *crossing,
                 const struct veil *sky, const struct veil *fog);

/* Light that comes from within the body: before lamps light the surface, which
 * it changes. */
rgb path_within(const struct path *path, struct crossing *crossing);

/* The light that the surface itself sends to the viewer, once lamps and what is
 * within have given it so much. */
rgb path_shade(const struct path *path, const struct crossing *crossing,
               rgb light, const struct diffuse_light *diffuse);

/* The same, once the lamps are asked for this surface alone. */
rgb path_light(const struct path *path, struct crossing *crossing);

/* From a surface that sends so much light: false if the ray ends here. Rays
 * that branch off are the wavefront's. */
bool path_leave(struct path *path, const struct crossing *crossing, rgb light);

/* The same from an opaque plain leaf (world/solid.h) of one layer, where it
 * ends. */
void path_leave_plain(struct path *path, const struct leaf *leaf,
                      const struct surface_paint *paint, rgb light);

#endif
