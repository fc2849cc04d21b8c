/* The light of all lamps on many surface points at once: one lamp after the
 * other looks at all of them (irregular.h), rays decide what it leaves in
 * doubt, and then every point sums the lamps that it sees. Nothing is left
 * out and nothing is drawn by chance. */
#ifndef LIGHTMESH_LAMP_SIGHTS_H
#define LIGHTMESH_LAMP_SIGHTS_H

#include "lightmesh/facet_light.h"
#include "lightmesh/irregular.h"

struct lamp_sights_options {
    const struct casters *casters;
    const struct lamps *lamps; /* all of them lamp_sights_take */
    const struct irregular_points *points;
    struct worker *const *workers; /* one for each thread */
    unsigned threads;
};

/* Whether a lamp can look at many points at once: light from one place, that
 * no fog weakens. */
bool lamp_sights_take(const struct lamps *lamps, const struct lamp *lamp);

/* Fills light[0..irregular_padded(points->count) - 1]. Of no use once the
 * workers are told to stop. */
void lamp_sights_sum(const struct lamp_sights_options *options,
                     struct facet_light *light);

/* Where a point is, and its normal. */
vec3 lamp_sights_place(const struct casters *casters,
                       const struct irregular_points *points, size_t number);
vec3 lamp_sights_normal(const struct irregular_points *points, size_t number);

#endif
