/* wrinkles: ten octaves of noise, each half as strong as the one before. */
#include "base/lesser.h"
#include "scene/noise.h"

static const struct octaves wrinkles_octaves = { OCTAVES_MAX, 1, 2 };

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
static void wrinkles_perturbations(const struct pattern *pattern,
                                   const struct spots *points, vec3 *tilts)
{
    vec3 noise[OCTAVES_MAX * SPOTS_MAX];
    const int count = points->count;
    (void)pattern;
    noise_vector_octaves(points, wrinkles_octaves, noise);
    for (int k = 0; k < count; k++) {
        vec3 sum = { 0, 0, 0 };
        double weight = 1;
        for (int i = 0; i < OCTAVES_MAX; i++, weight /= 2) {
            vec3 at = noise[i * count + k];
            vec3 size = { fabs(at.x), fabs(at.y), fabs(at.z) };
            sum = vec3_along(sum, size, weight);
        }
        tilts[k] = sum;
    }
}

const struct pattern_kind wrinkles_pattern = {
    .name = "wrinkles",
    .help = "noise of all sizes; as a normal, wrinkled",
    .values = wrinkles_values,
    .perturbations = wrinkles_perturbations,
};
