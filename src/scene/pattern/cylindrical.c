/* cylindrical: from 1 on the y axis to 0 on the unit cylinder and beyond. */
#include "scene/pattern.h"
#include "scene/spots.h"

static void cylindrical_values(const struct pattern *pattern,
                               const struct spots *spots, double *values)
{
    (void)pattern;
    for (int i = 0; i < spots->count; i++) {
        double x = spots->x[i], z = spots->z[i];
        double value = 1 - sqrt(x * x + z * z);
        values[i] = value > 0 ? value : 0;
    }
}

const struct pattern_kind cylindrical_pattern = {
    .name = "cylindrical",
    .help = "1 on the y axis to 0 at distance 1 of it",
    .values = cylindrical_values,
};
