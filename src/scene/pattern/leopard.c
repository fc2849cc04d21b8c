/* leopard: regularly spaced round spots. */
#include "scene/pattern.h"

static double leopard_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    double mean = (sin(point.x) + sin(point.y) + sin(point.z)) / 3;
    return mean * mean;
}

const struct pattern_kind leopard_pattern = {
    .name = "leopard",
    .help = "regular round spots",
    .value = leopard_value,
};
