/* bozo: plain noise. */
#include "scene/material.h"
#include "scene/noise.h"

static double bozo_value(const struct pattern *pattern, vec3 point)
{
    return noise_value(pattern_generator(pattern), point);
}

static void bozo_values(const struct pattern *pattern,
                        const struct spots *spots, double *values)
{
    noise_values(pattern_generator(pattern), spots, values);
}

static const struct blend_entry bozo_colours[] = {
    { 0.4, { 1, 1, 1, 0, 0 }, NULL }, { 0.4, { 0, 1, 0, 0, 0 }, NULL },
    { 0.6, { 0, 1, 0, 0, 0 }, NULL }, { 0.6, { 0, 0, 1, 0, 0 }, NULL },
    { 0.8, { 0, 0, 1, 0, 0 }, NULL }, { 0.8, { 1, 0, 0, 0, 0 }, NULL },
};

static const struct blend_map bozo_map = { bozo_colours, 6 };

const struct pattern_kind bozo_pattern = {
    .name = "bozo",
    .help = "smooth noise",
    .map = &bozo_map,
    .value = bozo_value,
    .values = bozo_values,
};
