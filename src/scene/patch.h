/* A shape's surface as simple parts that points can be picked on: how light is
 * sent to a surface that glows. The parts must cover it, and may cover more. */
#ifndef SCENE_PATCH_H
#define SCENE_PATCH_H

#include "base/affine.h"

enum patch_kind {
    PATCH_PARALLELOGRAM, /* at, at + a, at + a + b, at + b */
    PATCH_TRIANGLE,      /* at, at + a, at + b */
    PATCH_DISC,          /* around `at`, a and b its half axes */
    PATCH_BALL,          /* around `at`, its radius in `radius` */
    PATCH_POINT,         /* at, which stands for an area */
};

struct patch {
    enum patch_kind kind;
    vec3 at, a, b;
    double radius; /* of balls */
    double area;   /* of points */
};

enum { PATCHES_MAX = 6 };

/* The flat patch moved; not for balls, which may become egg-shaped. */
static inline struct patch patch_moved(const struct patch *patch,
                                       const affine *transform)
{
    struct patch moved = *patch;
    moved.at = affine_point(transform, patch->at);
    moved.a = affine_direction(transform, patch->a);
    moved.b = affine_direction(transform, patch->b);
    return moved;
}

#endif
