/* wrinkles: ten octaves of noise, each half as strong as the one before. */
#include "base/lesser.h"
#include "scene/noise.h"

static const struct octaves wrinkles_octaves = { OCTAVES_MAX, 2 };

static void wrinkles_values(const struct pattern *pattern,
                            const struct spots *spots, double *values)
{
    double noise[OCTAVES_MAX * SPOTS_MAX];
    noise_octaves(pattern_generator(pattern), spots, wrinkles_octaves, noise);
    for (int i = 0; i < spots->count; i++) {
        double weight = 0.5;
        values[i] = 0;
        for (int octave = 0; octave < OCTAVES_MAX; octave++, weight /= 2)
            values[i] +=
                weight *
                lesser(greater(noise[octave * spots->count + i], 0), 1);
    }
}

/* Measured: the components' magnitudes, so wrinkles lean to one side. */
static vec3 wrinkles_perturbation(const struct pattern *pattern, vec3 point,
                                  vec3 normal)
{
    vec3 sum = { 0, 0, 0 }, noise[OCTAVES_MAX];
    double weight = 1;
    (void)pattern;
    (void)normal;
    noise_vector_octaves(point, wrinkles_octaves, noise);
    for (int i = 0; i < OCTAVES_MAX; i++, weight /= 2) {
        vec3 size = { fabs(noise[i].x), fabs(noise[i].y), fabs(noise[i].z) };
        sum = vec3_along(sum, size, weight);
    }
    return sum;
}

const struct pattern_kind wrinkles_pattern = {
    .name = "wrinkles",
    .help = "noise of all sizes; as a normal, wrinkled",
    .values = wrinkles_values,
    .perturbation = wrinkles_perturbation,
};
