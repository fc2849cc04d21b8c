/* boxed: from 1 in the origin to 0 on the box from -1 to 1 and beyond. */
#include "scene/pattern.h"

static double boxed_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    return fmax(0, 1 - fmax(fabs(point.x), fmax(fabs(point.y), fabs(point.z))));
}

const struct pattern_kind boxed_pattern = {
    .name = "boxed",
    .help = "1 in the middle to 0 on the box of 2 units",
    .value = boxed_value,
};
