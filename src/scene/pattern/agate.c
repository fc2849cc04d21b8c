/* agate: banded stone, a sine along z bent by much turbulence. */
#include <string.h>

#include "base/octet_math.h"
#include "scene/material.h"
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

static void bands_values(octet *bands)
{
    *bands *= 2 * M_PI;
    octet_sin(bands);
    *bands = 0.5 * (1 + *bands);
    octet_ln(bands);
    *bands *= 0.77;
    octet_exp(bands);
}

/* Measured: exponent 0.77, 1.1 bands per unit, 1.3 bands per turbulence. */
static void agate_values(const struct pattern *pattern,
                         const struct spots *spots, double *values)
{
    const struct agate *agate = pattern->parameters;
    double bend[SPOTS_MAX];
    noise_turbulences(pattern_generator(pattern), spots, &pattern->turbulence,
                      bend);
    for (int first = 0; first < spots->count; first += OCTET) {
        const int count = spots->count - first;
        octet bands = { 0 };
        for (int i = 0; i < OCTET && i < count; i++)
            bands[i] = 1.3 * agate->turbulence * bend[first + i] +
                       1.1 * spots->z[first + i];
        bands_values(&bands);
        memcpy(values + first, &bands,
               (size_t)(count < OCTET ? count : OCTET) * sizeof *values);
    }
}

static const struct blend_entry agate_colours[] = {
    { 0, { 1, 1, 1, 0, 0 }, NULL },
    { 0.5, { 0.95, 0.75, 0.5, 0, 0 }, NULL },
    { 0.5, { 0.9, 0.7, 0.5, 0, 0 }, NULL },
    { 0.6, { 0.9, 0.7, 0.4, 0, 0 }, NULL },
    { 0.6, { 1, 0.7, 0.4, 0, 0 }, NULL },
    { 1, { 0.6, 0.3, 0, 0, 0 }, NULL },
};

static const struct blend_map agate_map = { agate_colours, 6 };

const struct pattern_kind agate_pattern = {
    .name = "agate",
    .help = "bent bands of stone",
    .size = sizeof(struct agate),
    .defaults = &agate_defaults,
    .items = agate_items,
    .map = &agate_map,
    .values = agate_values,
};
