/* marble: parallel bands across x, disturbed by turbulence along x only. */
#include "scene/material.h"
#include "scene/noise.h"

static double marble_value(const struct pattern *pattern, vec3 point)
{
    double shift = 0;
    if (pattern->turbulent)
        shift = pattern->turbulence.amount.x *
                noise_turbulence(pattern_generator(pattern), point,
                                 &pattern->turbulence);
    return point.x + shift;
}

static const struct blend_entry marble_colours[] = {
    { 0, { 0.9, 0.8, 0.8, 0, 0 }, NULL },
    { 0.9, { 0.9, 0.08, 0.08, 0, 0 }, NULL },
    { 0.9, { 0, 0, 0, 0, 0 }, NULL },
};

static const struct blend_map marble_map = { marble_colours, 3 };

const struct pattern_kind marble_pattern = {
    .name = "marble",
    .help = "bands across x that turbulence makes veins of",
    .wave = WAVE_TRIANGLE,
    .own_turbulence = true,
    .map = &marble_map,
    .value = marble_value,
};
