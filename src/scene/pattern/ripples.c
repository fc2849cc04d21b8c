/* ripples: ten circular waves of wavelength 1 from points of the unit sphere.
 * Frequency and phase change the waves themselves and then, as for every
 * pattern, the value (measured). */
#include "scene/noise.h"

static double ripples_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0;
    for (int i = 0; i < NOISE_WAVES; i++) {
        double distance = vec3_length(vec3_sub(point, noise_wave_source(i)));
        double cycles = distance * pattern->frequency + pattern->phase;
        sum += sin(2 * M_PI * cycles);
    }
    return 0.5 + 0.5 * sum / NOISE_WAVES;
}

const struct pattern_kind ripples_pattern = {
    .name = "ripples",
    .help = "circular waves of one length",
    .value = ripples_value,
};
