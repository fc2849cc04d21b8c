/* A walk through media. */
#ifndef TRACER_DRIFT_H
#define TRACER_DRIFT_H

#include "tracer/walk.h"

/* Follows the ray through media, if it is in any, for at most `distance`;
 * gathers what they give; `end` is what it meets there, or NULL. *distance
 * becomes how far it got. True if it was scattered and goes on from there. */
bool walk_drift(struct walk *walk, const struct draws *draws,
                const struct leaf *end, double *distance);

/* An estimate of what media let pass of light on such a way. */
rgb drift_through(const struct tracer *tracer, struct worker *worker,
                  const struct ray *ray, double distance,
                  const struct interiors *inside, uint64_t key);

#endif
