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

static void julia_values(const struct pattern *pattern,
                         const struct spots *spots, double *values)
{
    struct orbit_starts starts;
    orbit_starts_at(pattern->parameters, spots, &starts);
    orbit_values(pattern->parameters, &starts, values);
}

const struct pattern_kind julia_pattern = {
    .name = "julia",
    .help = "a Julia set in x and y",
    .size = sizeof(struct orbit),
    .defaults = &julia_defaults,
    .arguments = julia_arguments,
    .items = julia_items,
    .values = julia_values,
};
