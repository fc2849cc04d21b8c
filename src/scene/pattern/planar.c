/* planar: from 1 in the plane y = 0 to 0 one unit above and below it. */
#include "scene/pattern.h"

static double planar_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    return fmax(0, 1 - fabs(point.y));
}

const struct pattern_kind planar_pattern = {
    .name = "planar",
    .help = "1 at y = 0 to 0 at distance 1 of it",
    .value = planar_value,
};
