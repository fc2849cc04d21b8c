/* spherical: from 1 in the origin to 0 on the unit sphere and beyond. */
#include "scene/pattern.h"

static double spherical_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    return fmax(0, 1 - vec3_length(point));
}

const struct pattern_kind spherical_pattern = {
    .name = "spherical",
    .help = "1 in the middle to 0 at distance 1",
    .value = spherical_value,
};
