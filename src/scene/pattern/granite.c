/* granite: six octaves of folded noise, rough and spotty. */
#include "scene/noise.h"
#include "scene/slab.h"

/* Measured: |1/2 - n| with n noise cut to its middle half, from 4 features
 * per unit on. */
static void granite_values(const struct pattern *pattern,
                           const struct spots *spots, double *values)
{
    enum { GRANITE_OCTAVES = 6 };
    double noise[GRANITE_OCTAVES * SPOTS_MAX], sum[SPOTS_MAX] = { 0 };
    int count = spots->count;
    struct spots scaled = spots_scaled(spots, 4);
    noise_octaves(pattern_generator(pattern), &scaled,
                  (struct octaves){ GRANITE_OCTAVES, 2 }, noise);
    double weight = 1;
    for (int octave = 0; octave < GRANITE_OCTAVES; octave++, weight /= 2)
        for (int i = 0; i < count; i++)
            sum[i] +=
                weight * slab_min(fabs(0.5 - noise[octave * count + i]), 0.5);
    for (int i = 0; i < count; i++)
        values[i] = slab_min(sum[i], 1);
}

const struct pattern_kind granite_pattern = {
    .name = "granite",
    .help = "rough stone, four spots per unit",
    .values = granite_values,
};
