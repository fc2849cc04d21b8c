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

static double spiral1_value(const struct pattern *pattern, vec3 point)
{
    const struct spiral1 *spiral = pattern->parameters;
    return hypot(point.x, point.y) +
           spiral_winding(pattern, spiral->arms, point);
}

const struct pattern_kind spiral1_pattern = {
    .name = "spiral1",
    .help = "arms that wind around the z axis",
    .size = sizeof(struct spiral1),
    .arguments = spiral1_arguments,
    .wave = WAVE_TRIANGLE,
    .value = spiral1_value,
};
