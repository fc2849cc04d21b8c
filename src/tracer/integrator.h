/* How the light of a pixel is worked out. Each integrator is one file of
 * integrator/ and one row of its list.h: `recursive` asks a lighting method at
 * every surface it meets; `path` follows light from surface to surface itself
 * and asks none. */
#ifndef TRACER_INTEGRATOR_H
#define TRACER_INTEGRATOR_H

#include "base/draw.h"
#include "tracer/tracer.h"

/* What reaches a point, direct and indirect. */
struct path_light {
    rgb mean;
    rgb error; /* standard error of the mean */
};

struct integrator {
    const char *name;
    /* What it lights by if it asks no lighting method: --lighting NAME names
     * it, its `illuminate` is NULL. NULL: it asks the one that is chosen. */
    const struct lighting *own;
    /* Of one that takes samples; else NULL, and places of the picture have one
     * answer (tracer/tracer.h). */
    void (*ready)(struct tracer *tracer, struct worker *worker);
    struct radiance (*sample)(const struct tracer *tracer,
                              struct worker *worker, double x, double y,
                              const struct draws *draws);
    struct path_light (*irradiance)(const struct tracer *tracer,
                                    struct worker *worker, vec3 point,
                                    const vec3 *normal, unsigned samples,
                                    uint64_t seed);
};

/* That which draws by this lighting. */
const struct integrator *integrator_for(const struct lighting *lighting);

/* All that --lighting can name: the lighting methods, then those of integrators
 * that ask none. By number, NULL past the end; by name, or NULL. */
const struct lighting *integrator_lighting_at(size_t index);
const struct lighting *integrator_lighting_find(const char *name);

#endif
