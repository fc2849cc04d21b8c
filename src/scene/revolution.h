/* A curve turned around the y axis: lathes. */
#ifndef SCENE_REVOLUTION_H
#define SCENE_REVOLUTION_H

#include "scene/outline.h"
#include "scene/primitive.h"

struct revolution {
    struct terms segments; /* struct segment after segment, as numbers: x is the
                            * distance from the axis, y the height */
    bool bezier;           /* they are Bezier curves */
    bool sturm;            /* accepted: the roots are exact anyway */
    struct outline outline;
    struct rectangle around; /* of the outline or of control points */
    struct rectangle *boxes; /* of the segments, for uv */
};

extern const struct primitive lathe_primitive;

/* Makes the outline. Returns NULL, or why the shape is impossible. */
const char *revolution_prepare(void *shape, struct arena *arena,
                               const char **warning);

#endif
