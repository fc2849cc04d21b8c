/* What there is to see of a skeleton. */
#ifndef LIGHTING_SKELETON_VIEWS_H
#define LIGHTING_SKELETON_VIEWS_H

#include "lighting/show.h"
#include "skeleton/skeleton.h"

/* Its graph, by the radius of the void. */
void skeleton_show_graph(const struct skeleton *skeleton, struct show *show);

/* Its graph, by the irradiance at its nodes. */
void skeleton_show_light(const struct skeleton *skeleton, struct show *show);

/* Arrows that go with the light, the longer the more of it there is. */
void skeleton_show_stream(const struct skeleton *skeleton, struct show *show);

#endif
