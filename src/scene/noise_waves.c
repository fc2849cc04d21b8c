/* Circular waves of `waves` and `ripples`, eight at a time, of one point or of
 * several: see noise.h. */
#include <string.h>

#include "base/clones.h"
#include "base/octet_math.h"
#include "scene/noise_tables.h"
#include "scene/spots.h"

_Static_assert(NOISE_WAVES_LIMIT % OCTET == 0, "the last eight are whole");

struct wave_octet {
    double away[3][OCTET]; /* unit, from its source to the point */
    double angle[OCTET];   /* what its height is the sine of */
};

/* Those from number `first` on. */
CLONES static void find_waves(const struct noise_tables *restrict tables,
                              const struct noise_waves *restrict waves,
                              vec3 point, int first,
                              struct wave_octet *restrict out)
{
    const double frequency = waves->frequency, phase = waves->phase;
    const double *own = tables->wave_frequency + first;
    const bool uneven = waves->uneven;
    for (int i = 0; i < OCTET; i++) {
        const vec3 source = { tables->wave_source[0][first + i],
                              tables->wave_source[1][first + i],
                              tables->wave_source[2][first + i] };
        vec3 away = vec3_sub(point, source);
        double length = vec3_length(away);
        double scale = length > 0 ? 1 / length : 1;
        double each = uneven ? frequency * own[i] : frequency;
        out->angle[i] = 2 * M_PI * (length * each + phase);
        out->away[0][i] = away.x * scale;
        out->away[1][i] = away.y * scale;
        out->away[2][i] = away.z * scale;
    }
}

/* The waves from `first` on, and their heights. */
static void look_at_waves(const struct noise_waves *waves, vec3 point,
                          int first, struct wave_octet *at, octet *height)
{
    const struct noise_tables *tables = noise_tables();
    find_waves(tables, waves, point, first, at);
    memcpy(height, at->angle, sizeof *height);
    octet_sin(height);
    for (int i = 0; waves->uneven && i < OCTET; i++)
        (*height)[i] /= tables->wave_frequency[first + i];
}

struct noise_waves noise_waves_of(const struct pattern *pattern, bool uneven)
{
    return (struct noise_waves){ pattern->frequency, pattern->phase,
                                 pattern->noise->waves, uneven };
}

double noise_waves_height(const struct noise_waves *waves, vec3 point)
{
    struct wave_octet at;
    double sum = 0;
    octet height;
    for (int first = 0; first < waves->count; first += OCTET) {
        look_at_waves(waves, point, first, &at, &height);
        for (int i = 0; i < OCTET && first + i < waves->count; i++)
            sum += height[i];
    }
    return sum / waves->count;
}

static vec3 waves_tilt(const struct noise_waves *waves, vec3 point)
{
    struct wave_octet at;
    vec3 sum = { 0, 0, 0 };
    octet height;
    for (int first = 0; first < waves->count; first += OCTET) {
        look_at_waves(waves, point, first, &at, &height);
        for (int i = 0; i < OCTET && first + i < waves->count; i++)
            sum = vec3_along(
                sum, vec3_make(at.away[0][i], at.away[1][i], at.away[2][i]),
                height[i]);
    }
    return vec3_scale(sum, 1.0 / waves->count);
}

/* The same wave at points from number `first` on, as find_waves has it. */
CLONES static void find_wave(const struct noise_tables *restrict tables,
                             const struct noise_waves *restrict waves,
                             int number, const struct spots *restrict spots,
                             int first, struct wave_octet *restrict out)
{
    const vec3 source = { tables->wave_source[0][number],
                          tables->wave_source[1][number],
                          tables->wave_source[2][number] };
    const double phase = waves->phase;
    const double each = waves->uneven
                            ? waves->frequency * tables->wave_frequency[number]
                            : waves->frequency;
    for (int i = 0; i < OCTET; i++) {
        vec3 away = vec3_sub(spots_at(spots, first + i), source);
        double length = vec3_length(away);
        double scale = length > 0 ? 1 / length : 1;
        out->angle[i] = 2 * M_PI * (length * each + phase);
        out->away[0][i] = away.x * scale;
        out->away[1][i] = away.y * scale;
        out->away[2][i] = away.z * scale;
    }
}

/* Of one wave after the other, at OCTET points. */
static void waves_tilts(const struct noise_waves *waves,
                        const struct spots *spots, int first, vec3 tilts[OCTET])
{
    const struct noise_tables *tables = noise_tables();
    struct wave_octet at;
    octet height;
    for (int i = 0; i < OCTET; i++)
        tilts[i] = vec3_make(0, 0, 0);
    for (int k = 0; k < waves->count; k++) {
        find_wave(tables, waves, k, spots, first, &at);
        memcpy(&height, at.angle, sizeof height);
        octet_sin(&height);
        for (int i = 0; i < OCTET; i++)
            tilts[i] = vec3_along(
                tilts[i],
                vec3_make(at.away[0][i], at.away[1][i], at.away[2][i]),
                waves->uneven ? height[i] / tables->wave_frequency[k]
                              : height[i]);
    }
    for (int i = 0; i < OCTET; i++)
        tilts[i] = vec3_scale(tilts[i], 1.0 / waves->count);
}

/* So many points take less time together than each by itself. */
enum { POINTS_TOGETHER = 5 };

void noise_waves_tilts(const struct noise_waves *waves,
                       const struct spots *spots, vec3 *tilts)
{
    struct spots whole = *spots;
    int count = spots->count, at = 0;
    for (int i = count; i < SPOTS_MAX; i++)
        spots_put(&whole, i, spots_at(spots, 0));
    for (; count - at >= POINTS_TOGETHER; at += OCTET) {
        vec3 some[OCTET];
        int here = count - at < OCTET ? count - at : OCTET;
        waves_tilts(waves, &whole, at, some);
        memcpy(tilts + at, some, (size_t)here * sizeof *some);
    }
    for (; at < count; at++)
        tilts[at] = waves_tilt(waves, spots_at(spots, at));
}
