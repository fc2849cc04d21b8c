/* magnet KIND mandel N and magnet KIND julia <U, V>, N: the sets of two maps of
 * magnetism in the plane of x and y. The parser fills the parameters. */
#include "scene/orbit.h"
#include "scene/pattern.h"

static const struct orbit magnet_defaults = { ORBIT_DEFAULTS, .magnet = 1 };

/* For fingerprints; the parser has its own way. */
static const struct field magnet_arguments[] = {
    { "magnet", FIELD_INTEGER, offsetof(struct orbit, magnet), 0, 0,
      "1 or 2: which map", false },
    { "julia", FIELD_FLAG, offsetof(struct orbit, julia), 0, 0, "which set",
      false },
    { "constant", FIELD_VECTOR2, offsetof(struct orbit, constant), 0, 0,
      "of julia", false },
    ORBIT_ITERATIONS,
    { .name = NULL },
};

static const struct field magnet_items[] = {
    ORBIT_COLOURS,
    { .name = NULL },
};

static void magnet_values(const struct pattern *pattern,
                          const struct spots *spots, double *values)
{
    const struct orbit *orbit = pattern->parameters;
    struct orbit_starts starts;
    orbit_starts_at(orbit, spots, &starts);
    for (int i = 0; !orbit->julia && i < spots->count; i++) {
        starts.u[i] = starts.x[i];
        starts.v[i] = starts.y[i];
        starts.x[i] = starts.y[i] = 0;
    }
    orbit_magnets(orbit, &starts, values);
}

const struct pattern_kind magnet_pattern = {
    .name = "magnet",
    .help = "fractals of magnetism in x and y",
    .size = sizeof(struct orbit),
    .defaults = &magnet_defaults,
    .arguments = magnet_arguments,
    .items = magnet_items,
    .values = magnet_values,
};
