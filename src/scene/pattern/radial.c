/* radial: the angle around the y axis, one cycle per turn. */
#include "scene/pattern.h"

/* Measured: clockwise from -z when seen from above; within 0.001 of the axis
 * (in x and in z) a constant. */
static double radial_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    if (fabs(point.x) < 0.001 && fabs(point.z) < 0.001)
        return 0.25;
    return 0.25 + (atan2(point.x, point.z) + M_PI) / (2 * M_PI);
}

const struct pattern_kind radial_pattern = {
    .name = "radial",
    .help = "the angle around the y axis",
    .value = radial_value,
};
