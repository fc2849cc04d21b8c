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

static double dents_value(const struct pattern *pattern, vec3 point)
{
    struct spots spots = spots_of(point);
    double value;
    dents_values(pattern, &spots, &value);
    return value;
}

static vec3 dents_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    (void)normal;
    return vec3_scale(noise_vector(point), dents_value(pattern, point));
}

const struct pattern_kind dents_pattern = {
    .name = "dents",
    .help = "the cube of noise; as a normal, scattered dents",
    .values = dents_values,
    .perturbation = dents_perturbation,
};
