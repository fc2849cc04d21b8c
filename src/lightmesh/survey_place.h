/* The places where a survey asks what indirect light is worth. */
#ifndef LIGHTMESH_SURVEY_PLACE_H
#define LIGHTMESH_SURVEY_PLACE_H

#include "lightmesh/gather.h"
#include "scene/camera.h"

struct survey_place {
    struct surface surface; /* of `at` */
    struct intersection at;
};

/* What the camera shows there of the picture, whose sides are 1: what is met
 * first, or behind panes and in mirrors that show more of others than of
 * themselves. Returns false if that is nothing. *place must not be copied. */
bool survey_place_find(struct survey_place *place, const struct gather *gather,
                       const struct camera *camera, double x, double y);

#endif
