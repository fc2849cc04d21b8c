/* bumps: noise as a pigment; as a normal the noise vector is added. */
#include "scene/noise.h"

static double bumps_value(const struct pattern *pattern, vec3 point)
{
    return noise_value(pattern_generator(pattern), point);
}

static void bumps_values(const struct pattern *pattern,
                         const struct spots *spots, double *values)
{
    noise_values(pattern_generator(pattern), spots, values);
}

static vec3 bumps_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    (void)pattern;
    (void)normal;
    return noise_vector(point);
}

const struct pattern_kind bumps_pattern = {
    .name = "bumps",
    .help = "smooth noise; as a normal, smooth bumps",
    .value = bumps_value,
    .values = bumps_values,
    .perturbation = bumps_perturbation,
};
