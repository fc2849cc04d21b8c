/* wood: cylinders around the z axis, disturbed by turbulence in x and y. */
#include "scene/material.h"
#include "scene/noise.h"

/* Measured: a coordinate moves by the sine of itself and its turbulence, both
 * multiplied by the amount; never by more than 1. */
static double wood_value(const struct pattern *pattern, vec3 point)
{
    double x = point.x, y = point.y;
    if (pattern->turbulent) {
        const struct turbulence *turbulence = &pattern->turbulence;
        vec3 step = noise_vector_turbulence(point, turbulence);
        x += sin(2 * M_PI * (point.x + step.x) * turbulence->amount.x);
        y += sin(2 * M_PI * (point.y + step.y) * turbulence->amount.y);
    }
    return sqrt(x * x + y * y);
}

static const struct blend_entry wood_colours[] = {
    { 0.6, { 0.666, 0.312, 0.2, 0, 0 }, NULL },
    { 0.6, { 0.4, 0.1333, 0.066, 0, 0 }, NULL },
};

static const struct blend_map wood_map = { wood_colours, 2 };

const struct pattern_kind wood_pattern = {
    .name = "wood",
    .help = "year rings around the z axis",
    .wave = WAVE_TRIANGLE,
    .own_turbulence = true,
    .map = &wood_map,
    .value = wood_value,
};
