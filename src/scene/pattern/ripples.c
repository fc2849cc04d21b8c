/* ripples: ten circular waves of wavelength 1 from points of the unit sphere.
 * Frequency and phase change the waves themselves and then, as for every
 * pattern, the value (measured). */
#include "scene/noise.h"

static double ripples_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0;
    int waves = pattern->noise->waves;
    for (int i = 0; i < waves; i++) {
        double distance = vec3_length(vec3_sub(point, noise_wave_source(i)));
        double cycles = distance * pattern->frequency + pattern->phase;
        sum += sin(2 * M_PI * cycles);
    }
    return 0.5 + 0.5 * sum / waves;
}

static vec3 ripples_perturbation(const struct pattern *pattern, vec3 point,
                                 vec3 normal)
{
    vec3 sum = { 0, 0, 0 };
    int waves = pattern->noise->waves;
    (void)normal;
    for (int i = 0; i < waves; i++) {
        vec3 away = vec3_sub(point, noise_wave_source(i));
        double cycles = vec3_length(away) * pattern->frequency + pattern->phase;
        sum = vec3_along(sum, vec3_normalise(away), sin(2 * M_PI * cycles));
    }
    return vec3_scale(sum, 1.0 / waves);
}

const struct pattern_kind ripples_pattern = {
    .name = "ripples",
    .help = "circular waves of one length",
    .value = ripples_value,
    .perturbation = ripples_perturbation,
};
