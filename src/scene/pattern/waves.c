/* waves: as ripples, but each wave has its own length and is the higher the
 * longer it is. */
#include "scene/noise.h"

/* Cycles per unit: the spectrum of POV-Ray's waves. */
static const double wave_frequencies[NOISE_WAVES] = {
    0.17, 0.23, 0.40, 0.43, 0.69, 0.71, 0.78, 0.92, 0.96, 0.99,
};

static double waves_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0;
    for (int i = 0; i < NOISE_WAVES; i++) {
        double distance = vec3_length(vec3_sub(point, noise_wave_source(i)));
        double frequency = wave_frequencies[i];
        double cycles =
            distance * pattern->frequency * frequency + pattern->phase;
        sum += sin(2 * M_PI * cycles) / frequency;
    }
    return 0.5 + 0.2 * sum / NOISE_WAVES;
}

const struct pattern_kind waves_pattern = {
    .name = "waves",
    .help = "circular waves of many lengths",
    .value = waves_value,
};
