/* A ray of the recursive tracer on its way: shared by its files. */
#ifndef TRACER_BRANCH_H
#define TRACER_BRANCH_H

#include "tracer/crossing.h"
#include "tracer/tracer.h"

/* A ray on its way, and what it has gathered. */
struct path {
    const struct tracer *tracer;
    struct worker *worker;
    struct ray ray;
    enum ray_kind kind;
    int level;     /* 1 for camera rays */
    double weight; /* in the pixel, for adc_bailout */
    bool straight; /* the camera's line of sight: its opacity counts */
    struct interiors inside;
    const struct picture_place *place; /* of a camera ray that has met nothing
                                        * yet; else NULL */

    rgb share;      /* of what the ray meets next, in its radiance */
    double clear;   /* 1 - opacity so far */
    rgb light;      /* gathered */
    double opacity; /* once it has ended */
};

/* A camera ray, which is there, sets out; `place` may be NULL. */
void path_start(struct path *path, const struct tracer *tracer,
                struct worker *worker, const struct picture_place *place);

/* What it meets next: false if nothing. */
bool path_meet(struct path *path, struct intersection *at);

/* To the surface that it meets, or into the sky: false if the ray ends there.
 */
bool path_arrive(struct path *path, struct crossing *crossing, bool met);

/* Light that comes from within the body: before lamps light the surface, which
 * it changes. */
rgb path_within(const struct path *path, struct crossing *crossing);

/* The light that the surface itself sends to the viewer, once lamps and what is
 * within have given it so much. */
rgb path_shade(const struct path *path, const struct crossing *crossing,
               rgb light, const struct diffuse_light *diffuse);

/* From a surface that sends so much light: false if the ray ends here. */
bool path_leave(struct path *path, const struct crossing *crossing, rgb light);

/* Follows the ray to its end, from what it meets next, which is known or not
 * yet. */
struct radiance path_go_on(struct path *path, struct crossing *crossing,
                           bool met);
struct radiance path_follow(struct path *path);

/* Once it has ended. */
static inline struct radiance path_seen(const struct path *path)
{
    return (struct radiance){ path->light, path->opacity };
}

#endif
