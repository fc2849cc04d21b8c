/* waves: as ripples, but each wave has its own length and is the higher the
 * longer it is. */
#include "scene/noise.h"

static double waves_value(const struct pattern *pattern, vec3 point)
{
    struct noise_waves waves = noise_waves_of(pattern, true);
    return 0.5 + 0.2 * noise_waves_height(&waves, point);
}

static void waves_perturbations(const struct pattern *pattern,
                                const struct spots *points, vec3 *tilts)
{
    struct noise_waves waves = noise_waves_of(pattern, true);
    noise_waves_tilts(&waves, points, tilts);
}

const struct pattern_kind waves_pattern = {
    .name = "waves",
    .help = "circular waves of many lengths",
    .value = waves_value,
    .perturbations = waves_perturbations,
};
