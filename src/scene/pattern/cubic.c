/* cubic: the six sides of a cube around the origin, seen from there. */
#include "scene/pattern.h"

static const double cubic_colours[][3] = { { 1, 0, 0 }, { 0, 1, 0 },
                                           { 0, 0, 1 }, { 1, 1, 0 },
                                           { 0, 1, 1 }, { 1, 0, 1 } };

/* Measured: on edges +x, +y, +z win, in this order, then -x, -y, -z. */
static double cubic_value(const struct pattern *pattern, vec3 point)
{
    double x = fabs(point.x), y = fabs(point.y), z = fabs(point.z);
    double most = fmax(x, fmax(y, z));
    (void)pattern;
    if (point.x >= most)
        return 0;
    if (point.y >= most)
        return 1;
    if (point.z >= most)
        return 2;
    return x >= most ? 3 : y >= most ? 4 : 5;
}

const struct pattern_kind cubic_pattern = {
    .name = "cubic",
    .help = "six colours, one towards each side of a cube",
    .blocks = 6,
    .block_colours = cubic_colours,
    .value = cubic_value,
};
