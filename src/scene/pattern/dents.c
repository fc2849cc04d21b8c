/* dents: the cube of noise, so that most of the surface is level. */
#include "scene/noise.h"

static double dents_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    double noise = noise_value(point);
    return noise * noise * noise;
}

const struct pattern_kind dents_pattern = {
    .name = "dents",
    .help = "the cube of noise; as a normal, scattered dents",
    .value = dents_value,
};
