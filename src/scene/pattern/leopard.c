/* leopard: regularly spaced round spots. */
#include "base/octet_math.h"
#include "scene/pattern.h"
#include "scene/spots.h"

static void leopard_values(const struct pattern *pattern,
                           const struct spots *spots, double *values)
{
    struct spots sines;
    (void)pattern;
    for (int i = 0; i < spots->count; i++)
        spots_put(&sines, i, spots_at(spots, i));
    numbers_sin(sines.x, spots->count);
    numbers_sin(sines.y, spots->count);
    numbers_sin(sines.z, spots->count);
    for (int i = 0; i < spots->count; i++) {
        double mean = (sines.x[i] + sines.y[i] + sines.z[i]) / 3;
        values[i] = mean * mean;
    }
}

const struct pattern_kind leopard_pattern = {
    .name = "leopard",
    .help = "regular round spots",
    .values = leopard_values,
};
