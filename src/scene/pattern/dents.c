/* dents: the cube of noise, so that most of the surface is level. */
#include "scene/noise.h"
#include "scene/spots.h"

static void dents_values(const struct pattern *pattern,
                         const struct spots *spots, double *values)
{
    noise_values(pattern_generator(pattern), spots, values);
    for (int i = 0; i < spots->count; i++)
        values[i] = values[i] * values[i] * values[i];
}

static void dents_perturbations(const struct pattern *pattern,
                                const struct spots *points, vec3 *tilts)
{
    double values[SPOTS_MAX];
    dents_values(pattern, points, values);
    noise_vectors(points, tilts);
    for (int i = 0; i < points->count; i++)
        tilts[i] = vec3_scale(tilts[i], values[i]);
}

const struct pattern_kind dents_pattern = {
    .name = "dents",
    .help = "the cube of noise; as a normal, scattered dents",
    .values = dents_values,
    .perturbations = dents_perturbations,
};
