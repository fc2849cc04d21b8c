/* marble: parallel bands across x, disturbed by turbulence along x only. */
#include "scene/noise.h"

static double marble_value(const struct pattern *pattern, vec3 point)
{
    double shift = 0;
    if (pattern->turbulent)
        shift = pattern->turbulence.amount.x *
                noise_turbulence(point, &pattern->turbulence);
    return point.x + shift;
}

const struct pattern_kind marble_pattern = {
    .name = "marble",
    .help = "bands across x that turbulence makes veins of",
    .wave = WAVE_TRIANGLE,
    .own_turbulence = true,
    .value = marble_value,
};
