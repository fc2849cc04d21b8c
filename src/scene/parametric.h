/* Parametric surfaces: all points (x(u,v), y(u,v), z(u,v)). */
#ifndef SCENE_PARAMETRIC_H
#define SCENE_PARAMETRIC_H

#include "scene/container.h"
#include "scene/primitive.h"

struct function;
struct parametric_sheet;

struct parametric {
    const struct function *coordinate[3];
    double from[2], to[2]; /* of u and v */
    struct container container;
    double accuracy, max_gradient; /* needless: roots are exact */
    struct terms samples;          /* what tells it from others */
    const struct parametric_sheet *sheet;
};

extern const struct primitive parametric_primitive;

void parametric_init(struct parametric *surface);

/* The point at these coordinates. False: it is none, or takes more than
 * *steps_left steps of functions to find, which are counted down. */
bool parametric_point(const struct parametric *surface, const double uv[2],
                      unsigned long *steps_left, vec3 *point);

#endif
