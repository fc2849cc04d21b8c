/* spherical: from 1 in the origin to 0 on the unit sphere and beyond. */
#include "scene/pattern.h"
#include "scene/spots.h"

static void spherical_values(const struct pattern *pattern,
                             const struct spots *spots, double *values)
{
    (void)pattern;
    for (int i = 0; i < spots->count; i++) {
        double value = 1 - vec3_length(spots_at(spots, i));
        values[i] = value > 0 ? value : 0;
    }
}

const struct pattern_kind spherical_pattern = {
    .name = "spherical",
    .help = "1 in the middle to 0 at distance 1",
    .values = spherical_values,
};
