/* dents: the cube of noise, so that most of the surface is level. */
#include "scene/noise.h"

static double dents_value(const struct pattern *pattern, vec3 point)
{
    double noise = noise_value(pattern_generator(pattern), point);
    return noise * noise * noise;
}

static vec3 dents_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    (void)normal;
    return vec3_scale(noise_vector(point), dents_value(pattern, point));
}

const struct pattern_kind dents_pattern = {
    .name = "dents",
    .help = "the cube of noise; as a normal, scattered dents",
    .value = dents_value,
    .perturbation = dents_perturbation,
};
