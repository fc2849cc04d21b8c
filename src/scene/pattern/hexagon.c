/* hexagon: hexagonal prisms along y, sides of length 1, in three colours. */
#include "scene/pattern.h"

static const double hexagon_colours[][3] = { { 0, 0, 1 },
                                             { 0, 1, 0 },
                                             { 1, 0, 0 } };

/* What a whole number leaves over when divided by 3: fmod takes a while. */
static inline double left_of_thirds(double x)
{
    return fabs(x) < 1e15 ? x - 3 * floor(x / 3) : 0;
}

/* Centres are i (1.5, h) + j (0, 2h) in (x, z), h = sqrt(3)/2, with colour
 * (2i + j) mod 3. The nearest is found by cube rounding: of the three
 * coordinates whose sum is 0, the one rounded worst follows from the others.
 * Measured: the root of 3 has ten digits, and where z is 0 the side towards
 * +z counts. */
static double hexagon_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    double q = point.x / 1.5;
    double r = (point.z + 1e-12) / 1.732050808 - q / 2;
    double s = -q - r;
    double i = round(q), j = round(r), k = round(s);
    double di = fabs(i - q), dj = fabs(j - r), dk = fabs(k - s);
    if (di > dj && di > dk)
        i = -j - k;
    else if (dj > dk)
        j = -i - k;
    return left_of_thirds(2 * i + j);
}

const struct pattern_kind hexagon_pattern = {
    .name = "hexagon",
    .help = "hexagonal columns of three colours",
    .blocks = 3,
    .block_colours = hexagon_colours,
    .value = hexagon_value,
};
