/* granite: six octaves of folded noise, rough and spotty. */
#include "base/clones.h"
#include "base/lesser.h"
#include "scene/noise.h"

/* Measured: |1/2 - n| with n noise cut to its middle half, from 4 features
 * per unit on. */
CLONES static void granite_values(const struct pattern *pattern,
                                  const struct spots *spots, double *values)
{
    enum { GRANITE_OCTAVES = 6 };
    double noise[GRANITE_OCTAVES * SPOTS_MAX];
    noise_octaves(pattern_generator(pattern), spots,
                  (struct octaves){ GRANITE_OCTAVES, 4, 2 }, noise);
    for (int i = 0; i < spots->count; i++) {
        double sum = 0, weight = 1;
        for (int octave = 0; octave < GRANITE_OCTAVES; octave++, weight /= 2)
            sum += weight *
                   lesser(fabs(0.5 - noise[octave * spots->count + i]), 0.5);
        values[i] = lesser(sum, 1);
    }
}

const struct pattern_kind granite_pattern = {
    .name = "granite",
    .help = "rough stone, four spots per unit",
    .values = granite_values,
};
