/* waves: as ripples, but each wave has its own length and is the higher the
 * longer it is. */
#include "scene/noise.h"

/* Cycles per unit of POV-Ray's waves, 1/100 and these in 32767 (measured). */
static const int wave_numbers[NOISE_WAVES] = {
    29789, 31130, 13866, 22914, 22255, 32159, 25328, 12801, 7198, 5194,
};

static double wave_frequency(int i)
{
    return 0.01 + wave_numbers[i] / 32767.0;
}

static double waves_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0;
    for (int i = 0; i < NOISE_WAVES; i++) {
        double distance = vec3_length(vec3_sub(point, noise_wave_source(i)));
        double frequency = wave_frequency(i);
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
        double frequency = wave_frequency(i);
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
