/* triangular: triangles of side 1 in the plane of x and z, in six colours. */
#include "scene/pattern.h"

static const double triangular_colours[][3] = { { 1, 0, 0 }, { 0, 1, 0 },
                                                { 0, 0, 1 }, { 1, 1, 0 },
                                                { 0, 1, 1 }, { 1, 0, 1 } };

/* Measured: rows along x in which triangles stand upright and upside down by
 * turns, with blocks 0 3 4 5 2 1; every other row is shifted by half of that.
 */
static double triangular_value(const struct pattern *pattern, vec3 point)
{
    static const int upright[] = { 0, 4, 2 }, turned[] = { 3, 5, 1 };
    double height = sqrt(3) / 2, row = floor(point.z / height);
    double rise = point.z / height - row;
    double x = point.x + (fmod(row, 2) != 0 ? 1.5 : 0) - rise / 2;
    double column = ceil(x) - 1; /* a corner is the left one's */
    double block = fmod(column, 3);
    int i = (int)(block < 0 ? block + 3 : block);
    (void)pattern;
    return x - column < 1 - rise ? upright[i] : turned[i];
}

const struct pattern_kind triangular_pattern = {
    .name = "triangular",
    .help = "triangular columns of six colours",
    .blocks = 6,
    .block_colours = triangular_colours,
    .value = triangular_value,
};
