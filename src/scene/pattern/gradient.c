/* gradient V: distance along a direction, repeating at every unit. */
#include "base/clones.h"
#include "scene/pattern.h"
#include "scene/spots.h"

struct gradient {
    vec3 direction;
};

static const struct gradient gradient_defaults = { { 1, 0, 0 } };

static const struct field gradient_arguments[] = {
    { "direction", FIELD_VECTOR, offsetof(struct gradient, direction), 0, 0,
      "across the bands; its length does not matter", false },
    { .name = NULL },
};

/* Measured: only positive values are reduced here; negative ones are left to
 * the wave form and its slightly longer period. */
CLONES static void gradient_values(const struct pattern *pattern,
                                   const struct spots *restrict spots,
                                   double *restrict values)
{
    const struct gradient *gradient = pattern->parameters;
    const vec3 direction = vec3_normalise(gradient->direction);
    for (int i = 0; i < spots->count; i++) {
        double value = vec3_dot(spots_at(spots, i), direction);
        values[i] = value > 1 ? value - floor(value) : value;
    }
}

const struct pattern_kind gradient_pattern = {
    .name = "gradient",
    .help = "bands across a direction",
    .size = sizeof(struct gradient),
    .defaults = &gradient_defaults,
    .arguments = gradient_arguments,
    .values = gradient_values,
};
