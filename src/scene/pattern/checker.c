/* checker: unit cubes of alternating colours. */
#include "scene/pattern.h"

static const double checker_colours[][3] = { { 0, 0, 1 }, { 0, 1, 0 } };

/* The offset puts a surface at y = 0 (which rounding scatters on both sides)
 * into the cubes above it. Measured: 1e-10. */
static double checker_value(const struct pattern *pattern, vec3 point)
{
    const double offset = 1e-10;
    (void)pattern;
    double half = (floor(point.x + offset) + floor(point.y + offset) +
                   floor(point.z + offset)) /
                  2;
    return half == floor(half) ? 0 : 1;
}

const struct pattern_kind checker_pattern = {
    .name = "checker",
    .help = "unit cubes of two alternating colours",
    .blocks = 2,
    .block_colours = checker_colours,
    .value = checker_value,
};
