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

static vec3 waves_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    vec3 sum = { 0, 0, 0 };
    (void)normal;
    for (int i = 0; i < NOISE_WAVES; i++) {
        vec3 away = vec3_sub(point, noise_wave_source(i));
        double frequency = wave_frequencies[i];
        double cycles =
            vec3_length(away) * pattern->frequency * frequency + pattern->phase;
        sum = vec3_along(sum, vec3_normalise(away),
                         sin(2 * M_PI * cycles) / frequency);
    }
    return vec3_scale(sum, 1.0 / NOISE_WAVES);
}

const struct pattern_kind waves_pattern = {
    .name = "waves",
    .help = "circular waves of many lengths",
    .value = waves_value,
    .perturbation = waves_perturbation,
};
