/* wrinkles: ten octaves of noise, each half as strong as the one before. */
#include "scene/noise.h"

static double wrinkles_value(const struct pattern *pattern, vec3 point)
{
    double sum = 0, weight = 0.5, frequency = 1;
    (void)pattern;
    for (int i = 0; i < 10; i++, frequency *= 2, weight /= 2) {
        double noise = noise_value(vec3_scale(point, frequency));
        sum += weight * fmin(fmax(2 * noise - 0.5, 0), 1);
    }
    return sum;
}

const struct pattern_kind wrinkles_pattern = {
    .name = "wrinkles",
    .help = "noise of all sizes; as a normal, wrinkled",
    .value = wrinkles_value,
};
