/* planar: from 1 in the plane y = 0 to 0 one unit above and below it. */
#include "base/clones.h"
#include "base/lesser.h"
#include "scene/pattern.h"
#include "scene/spots.h"

CLONES static void planar_values(const struct pattern *pattern,
                                 const struct spots *restrict spots,
                                 double *restrict values)
{
    (void)pattern;
    for (int i = 0; i < spots->count; i++)
        values[i] = greater(1 - fabs(spots->y[i]), 0);
}

const struct pattern_kind planar_pattern = {
    .name = "planar",
    .help = "1 at y = 0 to 0 at distance 1 of it",
    .values = planar_values,
};
