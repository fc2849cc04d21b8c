/* cylindrical: from 1 on the y axis to 0 on the unit cylinder and beyond. */
#include "scene/pattern.h"

static double cylindrical_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    return fmax(0, 1 - hypot(point.x, point.z));
}

const struct pattern_kind cylindrical_pattern = {
    .name = "cylindrical",
    .help = "1 on the y axis to 0 at distance 1 of it",
    .value = cylindrical_value,
};
