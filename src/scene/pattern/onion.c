/* onion: concentric spherical shells, one per unit. */
#include "scene/pattern.h"

static double onion_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    double length = vec3_length(point);
    return length - floor(length);
}

const struct pattern_kind onion_pattern = {
    .name = "onion",
    .help = "concentric spheres",
    .value = onion_value,
};
