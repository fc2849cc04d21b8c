/* spiral1 N: N arms that wind around the z axis, one turn for a unit. */
#include "scene/spiral.h"

struct spiral1 {
    int arms;
};

static const struct field spiral1_arguments[] = {
    { "arms", FIELD_INTEGER, offsetof(struct spiral1, arms), 0, 0,
      "how many; negative ones turn the other way", false },
    { .name = NULL },
};

static void spiral1_values(const struct pattern *pattern,
                           const struct spots *spots, double *values)
{
    const struct spiral1 *spiral = pattern->parameters;
    double radii[SPOTS_MAX];
    spiral_winding(pattern, spiral->arms, spots, radii, values);
    for (int i = 0; i < spots->count; i++)
        values[i] = radii[i] + values[i];
}

const struct pattern_kind spiral1_pattern = {
    .name = "spiral1",
    .help = "arms that wind around the z axis",
    .size = sizeof(struct spiral1),
    .arguments = spiral1_arguments,
    .wave = WAVE_TRIANGLE,
    .values = spiral1_values,
};
