/* All that shines, ready to be sampled: the lamps, and surfaces that glow.
 * What the integrator `path` lights by. */
#ifndef TRACER_LIGHT_SET_H
#define TRACER_LIGHT_SET_H

#include "lighting/guide.h"
#include "lighting/lighting.h"
#include "shade/ambience.h"
#include "shade/emitters.h"
#include "shade/lamp.h"

struct light_set {
    struct lamp *lamps;
    double *sums; /* of the lamps' brightness, up to and with each */
    size_t count;
    struct emitters *emitters;
    struct ambience ambience;
    struct guide *guide; /* or NULL */
    uint64_t seed;
};

/* Its state is a light_set; it answers no questions, the integrator does. */
extern const struct lighting path_lighting;

/* A place on the lamp, uniform over its area: the light as `point` sees it
 * from there. */
struct lamp_pick {
    struct lamp_view view;
    vec3 towards;    /* the way of the light, unit, which for parallel area
                      * lights is not the one that the surface is lit from */
    double distance; /* of that way */
};

/* False if no light of it gets to the point, whatever is between. */
bool light_set_look(const struct lamp *lamp, vec3 point, const double u[2],
                    struct lamp_pick *pick);

#endif
