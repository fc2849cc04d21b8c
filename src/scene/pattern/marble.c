/* marble: parallel bands across x, disturbed by turbulence along x only. */
#include "scene/material.h"
#include "scene/noise.h"

static void marble_values(const struct pattern *pattern,
                          const struct spots *spots, double *values)
{
    double shift[SPOTS_MAX] = { 0 };
    if (pattern->turbulent)
        noise_turbulences(pattern_generator(pattern), spots,
                          &pattern->turbulence, shift);
    for (int i = 0; i < spots->count; i++)
        values[i] = spots->x[i] + pattern->turbulence.amount.x * shift[i];
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
    .values = marble_values,
};
