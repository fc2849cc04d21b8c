/* bozo: plain noise. */
#include "scene/noise.h"

static double bozo_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    return noise_value(point);
}

const struct pattern_kind bozo_pattern = {
    .name = "bozo",
    .help = "smooth noise",
    .value = bozo_value,
};
