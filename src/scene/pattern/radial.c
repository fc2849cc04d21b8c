/* radial: the angle around the y axis, one cycle per turn. */
#include "scene/material.h"

/* Measured: clockwise from -z when seen from above; within 0.001 of the axis
 * (in x and in z) a constant. */
static double radial_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    if (fabs(point.x) < 0.001 && fabs(point.z) < 0.001)
        return 0.25;
    return 0.25 + (atan2(point.x, point.z) + M_PI) / (2 * M_PI);
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
    .value = radial_value,
};
