/* wood: cylinders around the z axis, disturbed by turbulence in x and y. */
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

const struct pattern_kind wood_pattern = {
    .name = "wood",
    .help = "year rings around the z axis",
    .wave = WAVE_TRIANGLE,
    .own_turbulence = true,
    .value = wood_value,
};
