/* waves: as ripples, but each wave has its own length and is the higher the
 * longer it is. */
#include "scene/noise.h"

static struct noise_waves waves_of(const struct pattern *pattern)
{
    return (struct noise_waves){ pattern->frequency, pattern->phase,
                                 pattern->noise->waves, true };
}

static double waves_value(const struct pattern *pattern, vec3 point)
{
    struct noise_waves waves = waves_of(pattern);
    return 0.5 + 0.2 * noise_waves_height(&waves, point);
}

static vec3 waves_perturbation(const struct pattern *pattern, vec3 point,
                               vec3 normal)
{
    struct noise_waves waves = waves_of(pattern);
    (void)normal;
    return noise_waves_tilt(&waves, point);
}

const struct pattern_kind waves_pattern = {
    .name = "waves",
    .help = "circular waves of many lengths",
    .value = waves_value,
    .perturbation = waves_perturbation,
};
