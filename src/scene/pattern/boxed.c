/* boxed: from 1 in the origin to 0 on the box from -1 to 1 and beyond. */
#include "base/clones.h"
#include "base/lesser.h"
#include "scene/pattern.h"
#include "scene/spots.h"

CLONES static void boxed_values(const struct pattern *pattern,
                                const struct spots *restrict spots,
                                double *restrict values)
{
    (void)pattern;
    for (int i = 0; i < spots->count; i++) {
        double x = fabs(spots->x[i]), y = fabs(spots->y[i]);
        values[i] = greater(1 - greater(greater(fabs(spots->z[i]), y), x), 0);
    }
}

const struct pattern_kind boxed_pattern = {
    .name = "boxed",
    .help = "1 in the middle to 0 on the box of 2 units",
    .values = boxed_values,
};
