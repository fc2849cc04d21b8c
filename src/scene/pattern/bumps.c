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

static void bumps_perturbations(const struct pattern *pattern,
                                const struct spots *points, vec3 *tilts)
{
    (void)pattern;
    noise_vectors(points, tilts);
}

const struct pattern_kind bumps_pattern = {
    .name = "bumps",
    .help = "smooth noise; as a normal, smooth bumps",
    .value = bumps_value,
    .values = bumps_values,
    .perturbations = bumps_perturbations,
};
