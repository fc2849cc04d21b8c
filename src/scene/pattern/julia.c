/* julia <U, V>, N: the Julia set of u + iv in the plane of x and y. */
#include "scene/orbit.h"
#include "scene/pattern.h"

static const struct orbit julia_defaults = { ORBIT_DEFAULTS };

static const struct field julia_arguments[] = {
    { "constant", FIELD_VECTOR2, offsetof(struct orbit, constant), 0, 0,
      "c of z^n + c", false },
    ORBIT_ITERATIONS,
    { .name = NULL },
};

static const struct field julia_items[] = {
    ORBIT_ITEMS,
    { .name = NULL },
};

static double julia_value(const struct pattern *pattern, vec3 point)
{
    const struct orbit *orbit = pattern->parameters;
    return orbit_value(orbit, point.x, point.y, orbit->constant[0],
                       orbit->constant[1]);
}

const struct pattern_kind julia_pattern = {
    .name = "julia",
    .help = "a Julia set in x and y",
    .size = sizeof(struct orbit),
    .defaults = &julia_defaults,
    .arguments = julia_arguments,
    .items = julia_items,
    .value = julia_value,
};
