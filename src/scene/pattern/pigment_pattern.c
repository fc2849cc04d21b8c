/* pigment_pattern: how bright another pigment is. */
#include "scene/material.h"

static double pigment_pattern_seen(const struct pattern *pattern, vec3 point,
                                   const struct uv_source *surface)
{
    const struct made_pattern *made = pattern->parameters;
    if (!made->pigment)
        return 0;
    colour c = pigment_seen(made->pigment, point, surface);
    return grey_of(c.r, c.g, c.b);
}

static double pigment_pattern_value(const struct pattern *pattern, vec3 point)
{
    return pigment_pattern_seen(pattern, point, NULL);
}

const struct pattern_kind pigment_pattern_pattern = {
    .name = "pigment_pattern",
    .help = "how bright another pigment is: pigment_pattern { wood }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = pigment_pattern_value,
    .seen = pigment_pattern_seen,
};
