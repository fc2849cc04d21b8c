/* spiral2 N: as spiral1, but both ways, which makes a net. */
#include "scene/spiral.h"

struct spiral2 {
    int arms;
};

static const struct field spiral2_arguments[] = {
    { "arms", FIELD_INTEGER, offsetof(struct spiral2, arms), 0, 0,
      "how many; negative ones turn the other way", false },
    { .name = NULL },
};

/* Up from 0 to 1 and down again, in a unit. */
static double spiral2_triangle(double value)
{
    double v = value - floor(value);
    return v < 0.5 ? 2 * v : 2 * (1 - v);
}

/* Measured: rings, and the spiral of spiral1 over them. */
static void spiral2_values(const struct pattern *pattern,
                           const struct spots *spots, double *values)
{
    const struct spiral2 *spiral = pattern->parameters;
    double radii[SPOTS_MAX];
    spiral_winding(pattern, spiral->arms, spots, radii, values);
    for (int i = 0; i < spots->count; i++)
        values[i] =
            spiral2_triangle(radii[i]) + spiral2_triangle(radii[i] + values[i]);
}

const struct pattern_kind spiral2_pattern = {
    .name = "spiral2",
    .help = "arms that wind around the z axis, over rings",
    .size = sizeof(struct spiral2),
    .arguments = spiral2_arguments,
    .wave = WAVE_TRIANGLE,
    .values = spiral2_values,
};
