/* radial: the angle around the y axis, one cycle per turn. */
#include <string.h>

#include "base/octet_math.h"
#include "scene/material.h"
#include "scene/spots.h"

/* Measured: clockwise from -z when seen from above; within 0.001 of the axis
 * (in x and in z) a constant. */
static void radial_values(const struct pattern *pattern,
                          const struct spots *spots, double *values)
{
    int count = spots->count;
    (void)pattern;
    memcpy(values, spots->x, (size_t)count * sizeof *values);
    numbers_atan2(values, spots->z, count);
    for (int i = 0; i < count; i++) {
        bool middle = fabs(spots->x[i]) < 0.001 && fabs(spots->z[i]) < 0.001;
        values[i] = middle ? 0.25 : 0.25 + (values[i] + M_PI) / (2 * M_PI);
    }
}

static const struct blend_entry radial_colours[] = {
    { 0, { 0, 1, 1, 0, 0 }, NULL },
    { 0.333, { 1, 1, 0, 0, 0 }, NULL },
    { 0.666, { 1, 0, 1, 0, 0 }, NULL },
    { 1, { 0, 1, 1, 0, 0 }, NULL },
};

static const struct blend_map radial_map = { radial_colours, 4 };

const struct pattern_kind radial_pattern = {
    .name = "radial",
    .help = "the angle around the y axis",
    .map = &radial_map,
    .values = radial_values,
};
