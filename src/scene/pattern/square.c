/* square: squares of side 1 in the plane of x and z, in four colours. */
#include "scene/pattern.h"

static const double square_colours[][3] = {
    { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }
};

/* Measured: around each corner one of each, 0 where both coordinates are even,
 * 1 beyond it along z, then on in the same sense. */
static double square_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    bool x = pattern_odd(floor(point.x)), z = pattern_odd(floor(point.z));
    return x ? (z ? 2 : 3) : z;
}

const struct pattern_kind square_pattern = {
    .name = "square",
    .help = "square columns of four colours",
    .blocks = 4,
    .block_colours = square_colours,
    .value = square_value,
};
