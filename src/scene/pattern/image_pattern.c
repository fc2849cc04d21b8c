/* image_pattern: how bright a picture is, or how clear. */
#include "scene/image_map.h"

#include "image/image.h"

static double image_pattern_value(const struct pattern *pattern, vec3 point)
{
    const struct made_pattern *made = pattern->parameters;
    if (!made->image)
        return 0;
    const struct image_map *map = made->image;
    colour c = image_map_colour(map, point);
    /* Measured: palettes have alpha, be it 1 all over; of pictures without
     * alpha it is how red they are. */
    if (map->use_alpha && map->image)
        return map->image->has_alpha || map->image->palette ? c.transmit : c.r;
    return fmax(0, fmin(grey_of(c.r, c.g, c.b), 1));
}

const struct pattern_kind image_pattern_pattern = {
    .name = "image_pattern",
    .still = true,
    .help = "how bright a picture is: image_pattern { png \"a.png\" }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = image_pattern_value,
};
