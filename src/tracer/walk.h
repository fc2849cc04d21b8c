/* One path of light, followed backwards: shared by the files of the path
 * tracer. */
#ifndef TRACER_WALK_H
#define TRACER_WALK_H

#include "base/draw.h"
#include "tracer/tracer.h"

/* A ray on its way, and what it has gathered. */
struct walk {
    const struct tracer *tracer;
    struct worker *worker;
    struct draws draws; /* of this walk; vertices are parts of it */
    struct ray ray;
    enum ray_kind kind;
    struct interiors inside;
    int splits;    /* of the path so far */
    int level;     /* as the recursive tracer's, 1 after a scattering */
    double weight; /* of the walk in the pixel, for splitting */
    bool straight; /* the camera's line of sight: its opacity counts */

    bool split;     /* nothing has scattered the ray yet */
    double density; /* of its direction; 0: scattered by nothing, or mirrored
                     * or bent since */
    vec3 from;      /* where it was scattered */
    bool endless;   /* media have scattered it, in a scene that has its own */

    double base;  /* that the share is a part of, in the pixel */
    double worth; /* guided: what a ray should bring there; 0: unknown */
    int copies;   /* guided: rays that were made of one */
    bool judged;  /* by worth, and not by roulette */

    rgb share;    /* of what the ray meets next, in its radiance */
    double clear; /* 1 - opacity so far */
    rgb light;    /* gathered */
};

/* Follows the ray to its end. */
struct radiance walk_follow(struct walk *walk);

#endif
