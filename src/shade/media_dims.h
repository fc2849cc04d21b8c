/* What media let pass of the light on ways that no light is added to: shadow
 * rays, ways through smoke. No two places differ in light there, and none are
 * looked at but those that always are. What comes through is one exponential,
 * of the sum of what is at all of them. Places of several ways are looked at
 * together. */
#ifndef SHADE_MEDIA_DIMS_H
#define SHADE_MEDIA_DIMS_H

#include "scene/rays.h"
#include "scene/spots.h"
#include "shade/media.h"

/* The ways have numbers below RAY_LANES. */
struct media_dims {
    struct worker *worker;
    struct media_list media; /* that the places are in which are next */
    struct spots at;
    double weight[SPOTS_MAX];
    int way[SPOTS_MAX];
    rgb depth[RAY_LANES]; /* so far */
};

/* For so many ways, none of which is added yet. */
void media_dims_begin(struct media_dims *dims, struct worker *worker, int ways);

/* Adds a stretch of way number `number`. Its places do not depend on the other
 * ways. False if light is added on it, or more places may be needed: media_veil
 * then says what it lets pass. */
bool media_dims_add(struct media_dims *dims, const struct media_way *way,
                    int number);

/* Looks at the places that are left. */
void media_dims_look(struct media_dims *dims);

/* What is left of light on all stretches of a way, once all are looked at. */
rgb media_dims_through(const struct media_dims *dims, int number);

#endif
