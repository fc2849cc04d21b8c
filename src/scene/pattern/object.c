/* object: 1 inside of an object, 0 outside. */
#include "scene/object_probe.h"
#include "scene/pattern.h"

static const double object_colours[][3] = { { 0, 0, 1 }, { 0, 1, 0 } };

static double object_value(const struct pattern *pattern, vec3 point)
{
    const struct made_pattern *made = pattern->parameters;
    return made->object && object_inside(made->object, point);
}

const struct pattern_kind object_pattern = {
    .name = "object",
    .help = "outside, inside of an object: object { sphere { 0, 1 } rgb 1, "
            "rgb 0 }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .blocks = 2,
    .block_colours = object_colours,
    .value = object_value,
};
