/* checker: unit cubes of alternating colours. */
#include "base/clones.h"
#include "scene/pattern.h"
#include "scene/spots.h"

static const double checker_colours[][3] = { { 0, 0, 1 }, { 0, 1, 0 } };

/* The offset puts a surface at y = 0 (which rounding scatters on both sides)
 * into the cubes above it. Measured: 1e-10. */
CLONES static void checker_values(const struct pattern *pattern,
                                  const struct spots *restrict spots,
                                  double *restrict values)
{
    const double offset = 1e-10;
    (void)pattern;
    for (int i = 0; i < spots->count; i++) {
        double half =
            (floor(spots->x[i] + offset) + floor(spots->y[i] + offset) +
             floor(spots->z[i] + offset)) /
            2;
        values[i] = half == floor(half) ? 0 : 1;
    }
}

const struct pattern_kind checker_pattern = {
    .name = "checker",
    .help = "unit cubes of two alternating colours",
    .blocks = 2,
    .block_colours = checker_colours,
    .values = checker_values,
};
