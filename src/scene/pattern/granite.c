/* granite: six octaves of folded noise, rough and spotty. */
#include "scene/noise.h"
#include "scene/slab.h"

/* Measured: |1/2 - n| with n noise cut to its middle half, from 4 features
 * per unit on. */
static double granite_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0, frequency = 1;
    enum noise_generator generator = pattern_generator(pattern);
    for (int i = 0; i < 6; i++, frequency *= 2) {
        double noise = noise_wide(generator, vec3_scale(point, 4 * frequency));
        sum += slab_min(fabs(0.5 - noise), 0.5) / frequency;
    }
    return slab_min(sum, 1);
}

const struct pattern_kind granite_pattern = {
    .name = "granite",
    .help = "rough stone, four spots per unit",
    .value = granite_value,
};
