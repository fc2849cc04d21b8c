/* agate: banded stone, a sine along z bent by much turbulence. */
#include "scene/noise.h"

struct agate {
    double turbulence;
};

static const struct agate agate_defaults = { 1 };

static const struct field agate_items[] = {
    { "agate_turb", FIELD_FLOAT, offsetof(struct agate, turbulence), 0, 0,
      "strength of the bending, default 1", false },
    { .name = NULL },
};

/* Measured: exponent 0.77, 1.1 bands per unit, 1.3 bands per turbulence. */
static double agate_value(const struct pattern *pattern, vec3 point)
{
    const struct agate *agate = pattern->parameters;
    double bend = noise_turbulence(point, &pattern->turbulence);
    double bands = 1.3 * agate->turbulence * bend + 1.1 * point.z;
    return pow(0.5 * (1 + sin(2 * M_PI * bands)), 0.77);
}

const struct pattern_kind agate_pattern = {
    .name = "agate",
    .help = "bent bands of stone",
    .size = sizeof(struct agate),
    .defaults = &agate_defaults,
    .items = agate_items,
    .value = agate_value,
};
