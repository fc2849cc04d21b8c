/* pigment_pattern: how bright another pigment is. */
#include "scene/material.h"
#include "scene/spots.h"

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

static void pigment_pattern_values(const struct pattern *pattern,
                                   const struct spots *spots, double *values)
{
    const struct made_pattern *made = pattern->parameters;
    colour colours[SPOTS_MAX];
    if (made->pigment)
        pigment_colours(made->pigment, spots, colours);
    for (int i = 0; i < spots->count; i++)
        values[i] = made->pigment
                        ? grey_of(colours[i].r, colours[i].g, colours[i].b)
                        : 0;
}

static bool pigment_pattern_of_space(const struct pattern *pattern, int *budget)
{
    const struct made_pattern *made = pattern->parameters;
    return !made->pigment || pigment_all_of_space(made->pigment, budget);
}

const struct pattern_kind pigment_pattern_pattern = {
    .name = "pigment_pattern",
    .help = "how bright another pigment is: pigment_pattern { wood }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = pigment_pattern_value,
    .values = pigment_pattern_values,
    .seen = pigment_pattern_seen,
    .of_space = pigment_pattern_of_space,
};
