/* ripples: ten circular waves of wavelength 1 from points of the unit sphere.
 * Frequency and phase change the waves themselves and then, as for every
 * pattern, the value (measured). */
#include "scene/noise.h"

static double ripples_value(const struct pattern *pattern, vec3 point)
{
    struct noise_waves waves = noise_waves_of(pattern, false);
    return 0.5 + 0.5 * noise_waves_height(&waves, point);
}

static void ripples_perturbations(const struct pattern *pattern,
                                  const struct spots *points, vec3 *tilts)
{
    struct noise_waves waves = noise_waves_of(pattern, false);
    noise_waves_tilts(&waves, points, tilts);
}

const struct pattern_kind ripples_pattern = {
    .name = "ripples",
    .help = "circular waves of one length",
    .value = ripples_value,
    .perturbations = ripples_perturbations,
};
