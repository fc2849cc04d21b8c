/* wood: cylinders around the z axis, disturbed by turbulence in x and y. */
#include "base/octet_math.h"
#include "scene/material.h"
#include "scene/noise.h"

/* Measured: a coordinate moves by the sine of itself and its turbulence, both
 * multiplied by the amount; never by more than 1. */
static void wood_turn(const struct turbulence *turbulence,
                      const struct spots *spots, double *x, double *y)
{
    const vec3 amount = turbulence->amount;
    vec3 steps[SPOTS_MAX];
    noise_vector_turbulences(spots, turbulence, steps);
    for (int i = 0; i < spots->count; i++) {
        x[i] = 2 * M_PI * (spots->x[i] + steps[i].x) * amount.x;
        y[i] = 2 * M_PI * (spots->y[i] + steps[i].y) * amount.y;
    }
    numbers_sin(x, spots->count);
    numbers_sin(y, spots->count);
}

static void wood_values(const struct pattern *pattern,
                        const struct spots *spots, double *values)
{
    double turned_x[SPOTS_MAX], turned_y[SPOTS_MAX];
    if (pattern->turbulent)
        wood_turn(&pattern->turbulence, spots, turned_x, turned_y);
    for (int i = 0; i < spots->count; i++) {
        double x = spots->x[i] + (pattern->turbulent ? turned_x[i] : 0);
        double y = spots->y[i] + (pattern->turbulent ? turned_y[i] : 0);
        values[i] = sqrt(x * x + y * y);
    }
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
    .values = wood_values,
};
