/* image_pattern: how bright a picture is, or its alpha. */
#include "scene/image_map.h"

static double image_pattern_value(const struct pattern *pattern, vec3 point)
{
    const struct made_pattern *made = pattern->parameters;
    if (!made->image)
        return 0;
    colour c = image_map_colour(made->image, point);
    if (made->image->alpha == ALPHA_ALWAYS)
        return 1 - c.transmit;
    return grey_of(c.r, c.g, c.b);
}

const struct pattern_kind image_pattern_pattern = {
    .name = "image_pattern",
    .help = "how bright a picture is: image_pattern { png \"a.png\" }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = image_pattern_value,
};
