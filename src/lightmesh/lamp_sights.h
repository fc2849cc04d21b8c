/* All lamps and many surface points at once: one lamp after the other looks at
 * all of them (irregular.h), rays decide what it leaves in doubt, and then
 * every point may sum the lamps that it sees. Nothing is left out and nothing
 * is drawn by chance. */
#ifndef LIGHTMESH_LAMP_SIGHTS_H
#define LIGHTMESH_LAMP_SIGHTS_H

#include "lightmesh/facet_light.h"
#include "lightmesh/irregular.h"

struct lamp_sights_options {
    const struct casters *casters;
    const struct lamps *lamps;
    const bool *takes; /* by lamp: what lamp_sights_take says */
    const struct irregular_points *points;
    struct worker *const *workers; /* one for each thread */
    unsigned threads;
};

/* Whether a lamp can look at many points at once: light from one place, that no
 * fog weakens, and so near that rounding takes no surface within `detail` for
 * another. */
bool lamp_sights_take(const struct lamps *lamps, const struct lamp *lamp,
                      const struct casters *casters, double detail);

/* Which points each lamp sees: bit i % 64 of word i / 64 of so many words, lamp
 * after lamp; none of lamps that can't look at many at once. Of no use once the
 * workers are told to stop. */
void lamp_sights_look(const struct lamp_sights_options *options, uint64_t *lit);

/* The light of those that they see: fills light[0..irregular_padded(points) -
 * 1].
 */
void lamp_sights_sum(const struct lamp_sights_options *options,
                     const uint64_t *lit, struct facet_light *light);

/* Where a point is, and its normal. */
vec3 lamp_sights_place(const struct casters *casters,
                       const struct irregular_points *points, size_t number);
vec3 lamp_sights_normal(const struct irregular_points *points, size_t number);

#endif
