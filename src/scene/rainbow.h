/* A rainbow: colours by the angle between a ray and one direction. */
#ifndef SCENE_RAINBOW_H
#define SCENE_RAINBOW_H

#include "base/vec.h"

struct blend_map;

struct rainbow {
    vec3 direction;  /* unit, to the middle of its circle */
    vec3 up;         /* to the middle of its arc */
    double angle;    /* degrees, of the middle of its band */
    double width;    /* degrees, of the band, > 0 */
    double arc;      /* degrees, of the circle that is seen; HUGE_VAL: not said,
                      * all of it is, and full */
    double falloff;  /* degrees of it that are seen full, at most `arc`;
                      * HUGE_VAL: not said, all */
    double distance; /* > 0: 1/e of what is behind is left */
    double jitter;   /* of the place in the map, at random */
    const struct blend_map *map;
};

#endif
