/* spotted: in 3.7 another word for bozo. */
#include "scene/noise.h"

static double spotted_value(const struct pattern *pattern, vec3 point)
{
    return noise_value(pattern_generator(pattern), point);
}

static void spotted_values(const struct pattern *pattern,
                           const struct spots *spots, double *values)
{
    noise_values(pattern_generator(pattern), spots, values);
}

const struct pattern_kind spotted_pattern = {
    .name = "spotted",
    .help = "smooth noise, as bozo",
    .value = spotted_value,
    .values = spotted_values,
};
