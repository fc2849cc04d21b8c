/* wrinkles: ten octaves of noise, each half as strong as the one before. */
#include "scene/noise.h"

static double wrinkles_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0, weight = 0.5, frequency = 1;
    enum noise_generator generator = pattern_generator(pattern);
    for (int i = 0; i < 10; i++, frequency *= 2, weight /= 2) {
        double noise = noise_wide(generator, vec3_scale(point, frequency));
        sum += weight * fmin(fmax(noise, 0), 1);
    }
    return sum;
}

/* Measured: the components' magnitudes, so wrinkles lean to one side. */
static vec3 wrinkles_perturbation(const struct pattern *pattern, vec3 point,
                                  vec3 normal)
{
    vec3 sum = { 0, 0, 0 };
    double frequency = 1;
    (void)pattern;
    (void)normal;
    for (int i = 0; i < 10; i++, frequency *= 2) {
        vec3 noise = noise_vector(vec3_scale(point, frequency));
        vec3 size = { fabs(noise.x), fabs(noise.y), fabs(noise.z) };
        sum = vec3_along(sum, size, 1 / frequency);
    }
    return sum;
}

const struct pattern_kind wrinkles_pattern = {
    .name = "wrinkles",
    .help = "noise of all sizes; as a normal, wrinkled",
    .value = wrinkles_value,
    .perturbation = wrinkles_perturbation,
};
