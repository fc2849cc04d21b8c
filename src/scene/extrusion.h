/* An outline with a thickness: prisms, and the letters of text. */
#ifndef SCENE_EXTRUSION_H
#define SCENE_EXTRUSION_H

#include "scene/outline.h"
#include "scene/primitive.h"

struct extrusion {
    struct terms segments; /* struct segment after segment, as numbers */
    double low, high;      /* from here to there along the axis */
    int axis;              /* 1: y, the outline in x and z; 2: z, in x and y */
    bool conic; /* the outline is that at 1, and shrinks to a point at 0 */
    bool open;  /* no caps */
    struct outline outline;
    struct box3 around; /* the shape, and a little more, in u, v, w */
    double margin;      /* as little, in the outline's plane */
    bool tipped;        /* a cone that reaches its tip, or nearly */
};

extern const struct primitive prism_primitive, text_primitive;

/* Makes the outline. Returns NULL, or why the shape is impossible. */
const char *extrusion_prepare(void *shape, struct arena *arena,
                              const char **warning);

#endif
