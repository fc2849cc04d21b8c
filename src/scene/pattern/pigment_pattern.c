/* pigment_pattern: how bright another pigment is. */
#include "scene/material.h"

static double pigment_pattern_value(const struct pattern *pattern, vec3 point)
{
    const struct made_pattern *made = pattern->parameters;
    if (!made->pigment)
        return 0;
    colour c = pigment_colour(made->pigment, point);
    return 0.297 * c.r + 0.589 * c.g + 0.114 * c.b;
}

const struct pattern_kind pigment_pattern_pattern = {
    .name = "pigment_pattern",
    .help = "how bright another pigment is: pigment_pattern { wood }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = pigment_pattern_value,
};
