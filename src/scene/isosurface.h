/* Isosurfaces: where a function of space has a value, within a box or a ball.
 */
#ifndef SCENE_ISOSURFACE_H
#define SCENE_ISOSURFACE_H

#include "scene/container.h"
#include "scene/primitive.h"

struct function;

struct isosurface {
    const struct function *function;
    struct terms samples; /* of the function: what tells it from others */
    struct container container;
    double threshold;    /* inside is what is below it */
    double accuracy;     /* two crossings nearer to each other may be missed */
    double max_gradient; /* the function changes no faster */
    bool open;           /* the box or ball is not seen */
};

extern const struct primitive isosurface_primitive;

/* With POV-Ray's defaults. */
void isosurface_init(struct isosurface *surface);

#endif
