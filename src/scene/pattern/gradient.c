/* gradient V: distance along a direction, repeating at every unit. */
#include "scene/pattern.h"

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
static double gradient_value(const struct pattern *pattern, vec3 point)
{
    const struct gradient *gradient = pattern->parameters;
    double value = vec3_dot(point, vec3_normalise(gradient->direction));
    return value > 1 ? value - floor(value) : value;
}

const struct pattern_kind gradient_pattern = {
    .name = "gradient",
    .help = "bands across a direction",
    .size = sizeof(struct gradient),
    .defaults = &gradient_defaults,
    .arguments = gradient_arguments,
    .value = gradient_value,
};
