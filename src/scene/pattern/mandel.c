/* mandel N: the Mandelbrot set in the plane of x and y. */
#include "scene/orbit.h"
#include "scene/pattern.h"

static const struct orbit mandel_defaults = { ORBIT_DEFAULTS };

static const struct field mandel_arguments[] = {
    ORBIT_ITERATIONS,
    { .name = NULL },
};

static const struct field mandel_items[] = {
    ORBIT_ITEMS,
    { .name = NULL },
};

static double mandel_value(const struct pattern *pattern, vec3 point)
{
    return orbit_value(pattern->parameters, point.x, point.y, point.x, point.y);
}

const struct pattern_kind mandel_pattern = {
    .name = "mandel",
    .help = "the Mandelbrot set in x and y",
    .size = sizeof(struct orbit),
    .defaults = &mandel_defaults,
    .arguments = mandel_arguments,
    .items = mandel_items,
    .value = mandel_value,
};
