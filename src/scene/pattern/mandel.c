/* mandel N: the Mandelbrot set in the plane of x and y. */
#include "scene/material.h"
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

static void mandel_values(const struct pattern *pattern,
                          const struct spots *spots, double *values)
{
    struct orbit_starts starts;
    orbit_starts_at(pattern->parameters, spots, &starts);
    for (int i = 0; i < spots->count; i++) {
        starts.u[i] = starts.x[i];
        starts.v[i] = starts.y[i];
    }
    orbit_values(pattern->parameters, &starts, values);
}

/* Measured. */
static const struct blend_entry mandel_colours[] = {
    { 0, { 0, 0, 0, 0, 0 }, NULL },     { 0.001, { 0, 0, 0, 0, 0 }, NULL },
    { 0.001, { 0, 1, 1, 0, 0 }, NULL }, { 0.012, { 1, 1, 0, 0, 0 }, NULL },
    { 0.015, { 1, 0, 1, 0, 0 }, NULL }, { 0.1, { 0, 1, 1, 0, 0 }, NULL },
};

static const struct blend_map mandel_map = { mandel_colours, 6 };

/* Measured: sets of z^3 + c and beyond are grey. */
static bool mandel_mapped(const void *parameters)
{
    const struct orbit *orbit = parameters;
    return orbit->exponent == 2;
}

const struct pattern_kind mandel_pattern = {
    .name = "mandel",
    .help = "the Mandelbrot set in x and y",
    .size = sizeof(struct orbit),
    .defaults = &mandel_defaults,
    .arguments = mandel_arguments,
    .items = mandel_items,
    .map = &mandel_map,
    .mapped = mandel_mapped,
    .values = mandel_values,
};
