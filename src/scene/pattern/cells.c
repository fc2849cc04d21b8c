/* cells: one random value for each unit cube. */
#include "scene/noise.h"

/* A cube begins a little before its corner, so that surfaces that lie exactly
 * on its side are in one of them. */
static double cells_value(const struct pattern *pattern, vec3 point)
{
    const double slack = 1e-7;
    (void)pattern;
    return noise_cell_point(floor(point.x + slack), floor(point.y + slack),
                            floor(point.z + slack))
        .x;
}

const struct pattern_kind cells_pattern = {
    .name = "cells",
    .help = "one random value for each unit cube",
    .value = cells_value,
};
