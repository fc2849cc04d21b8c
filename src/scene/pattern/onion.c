/* onion: concentric spherical shells, one per unit. */
#include "base/clones.h"
#include "scene/pattern.h"
#include "scene/spots.h"

CLONES static void onion_values(const struct pattern *pattern,
                                const struct spots *restrict spots,
                                double *restrict values)
{
    (void)pattern;
    for (int i = 0; i < spots->count; i++) {
        double length = vec3_length(spots_at(spots, i));
        values[i] = length - floor(length);
    }
}

const struct pattern_kind onion_pattern = {
    .name = "onion",
    .help = "concentric spheres",
    .values = onion_values,
};
