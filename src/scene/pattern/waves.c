/* waves: as ripples, but each wave has its own length and is the higher the
 * longer it is. */
#include "scene/noise.h"

static double waves_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0;
    int waves = pattern->noise->waves;
    for (int i = 0; i < waves; i++) {
        double distance = vec3_length(vec3_sub(point, noise_wave_source(i)));
        double frequency = noise_wave_frequency(i);
        double cycles =
            distance * pattern->frequency * frequency + pattern->phase;
        sum += sin(2 * M_PI * cycles) / frequency;
    }
    return 0.5 + 0.2 * sum / waves;
}

static vec3 waves_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    vec3 sum = { 0, 0, 0 };
    int waves = pattern->noise->waves;
    (void)normal;
    for (int i = 0; i < waves; i++) {
        vec3 away = vec3_sub(point, noise_wave_source(i));
        double frequency = noise_wave_frequency(i);
        double cycles =
            vec3_length(away) * pattern->frequency * frequency + pattern->phase;
        sum = vec3_along(sum, vec3_normalise(away),
                         sin(2 * M_PI * cycles) / frequency);
    }
    return vec3_scale(sum, 1.0 / waves);
}

const struct pattern_kind waves_pattern = {
    .name = "waves",
    .help = "circular waves of many lengths",
    .value = waves_value,
    .perturbation = waves_perturbation,
};
