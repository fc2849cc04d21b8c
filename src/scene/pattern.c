/* Patterns: the list, where they are evaluated, and how raw values are folded
 * into [0,1]. All constants were measured with POV-Ray 3.7. */
#include "scene/pattern.h"

#include "base/clones.h"
#include "base/listing.h"
#include "base/power.h"
#include "scene/function.h"
#include "scene/material.h"
#include "scene/noise.h"
#include "scene/object.h"
#include "scene/spots.h"
#include "scene/samples.h"
#include "scene/warp.h"

#define X(name) extern const struct pattern_kind name##_pattern;
#include "scene/pattern/list.h"
#undef X

static const struct pattern_kind *const kinds[] = {
#define X(name) &name##_pattern,
#include "scene/pattern/list.h"
#undef X
};

LISTING(pattern, pattern_kind, kinds);

struct pattern pattern_new(struct arena *arena, const struct pattern_kind *kind)
{
    struct pattern pattern = {
        .kind = kind,
        .wave = kind ? kind->wave : WAVE_RAMP,
        .exponent = 1,
        .frequency = 1,
        .turbulence = { { 0, 0, 0 }, 6, 0.5, 2 },
        .noise = &noise_settings_default,
    };
    pattern_lay(&pattern, affine_identity());
    if (kind && kind->size) {
        pattern.parameters = arena_alloc(arena, kind->size);
        if (kind->defaults)
            memcpy(pattern.parameters, kind->defaults, kind->size);
    }
    return pattern;
}

const struct field made_pattern_fields[] = {
    { "samples", FIELD_TERMS, offsetof(struct made_pattern, samples), 0, 0,
      "values of what it is made of" },
    { NULL },
};

static const struct made_pattern *pattern_made(const struct pattern *pattern)
{
    bool made =
        pattern->kind && pattern->kind->arguments == made_pattern_fields;
    return made ? pattern->parameters : NULL;
}

double pattern_work(const struct pattern *pattern)
{
    const struct made_pattern *made = pattern_made(pattern);
    if (!made)
        return 1;
    return 1 + (made->function ? made->function->work : 0) +
           (made->pigment ? made->pigment->work : 0) +
           (made->object ? (double)made->object->more->parts : 0);
}

unsigned pattern_levels(const struct pattern *pattern)
{
    const struct made_pattern *made = pattern_made(pattern);
    if (!made)
        return 0;
    return 1 + (made->function  ? made->function->levels
                : made->pigment ? made->pigment->levels
                                : 0);
}

const struct blend_map *pattern_map(const struct pattern *pattern)
{
    const struct pattern_kind *kind = pattern->kind;
    if (!kind || (kind->mapped && !kind->mapped(pattern->parameters)))
        return NULL;
    return kind->map;
}

int pattern_generator(const struct pattern *pattern)
{
    return pattern->generator ? pattern->generator
                              : (int)pattern->noise->generator;
}

static double pattern_sample(const void *thing, vec3 point)
{
    const struct pattern *pattern = thing;
    const struct made_pattern *made = pattern->parameters;
    if (made->function)
        return function_sample(made->function, point);
    return pattern->kind->value(pattern, point);
}

void pattern_take_samples(struct arena *arena, struct pattern *pattern)
{
    struct made_pattern *made = pattern->parameters;
    made->samples = samples_take(arena, pattern_sample, pattern);
}

void pattern_lay(struct pattern *pattern, affine inverse)
{
    pattern->inverse = inverse;
    pattern->cofactors = affine_cofactors(&inverse);
}

void pattern_transform(struct pattern *pattern, const affine *transform)
{
    affine inverse;
    if (affine_inverse(*transform, &inverse))
        pattern_lay(pattern, affine_compose(pattern->inverse, inverse));
}

affine pattern_affine(const struct pattern *pattern)
{
    affine all = pattern->inverse;
    for (const struct warp *w = pattern->warps; w; w = w->inner)
        all = affine_compose(w->inverse, all);
    return all;
}

vec3 pattern_locate(const struct pattern *pattern, vec3 point)
{
    point = affine_point(&pattern->inverse, point);
    if (pattern->warps)
        point = warp_all(pattern->warps, point);
    if (!pattern->turbulent || (pattern->kind && pattern->kind->own_turbulence))
        return point;
    vec3 step = noise_vector_turbulence(point, &pattern->turbulence);
    return vec3_add(point, vec3_mul(pattern->turbulence.amount, step));
}

void pattern_locate_all(const struct pattern *pattern,
                        const struct spots *points, struct spots *located)
{
    spots_moved(points, &pattern->inverse, located);
    if (pattern->warps)
        warps_move(pattern->warps, located);
    if (pattern->turbulent && !(pattern->kind && pattern->kind->own_turbulence))
        noise_vectors_stir(located, &pattern->turbulence);
}

/* As fmod, which takes long: for numbers that are not too large by differences,
 * all of them exact, since neither number is ever twice the other (P. Sterbenz,
 * Floating-Point Computation, 1974). */
static double pattern_rest(double value, double period)
{
    double rest = fabs(value);
    if (!(rest < 16 * period))
        return fmod(value, period);
    for (double part = 8 * period; part >= period; part /= 2)
        rest = rest >= part ? rest - part : rest;
    return copysign(rest, value);
}

/* The period is 1.00001, not 1: with it a value of exactly 1 is the end of a
 * colour map and not its start. frequency 0 leaves values above 1 alone. */
static const double pattern_period = 1.00001;

static double pattern_cycle(const struct pattern *pattern, double value)
{
    if (pattern->frequency == 0)
        return value < 0 ? value - floor(value) : value;
    value = value * pattern->frequency + pattern->phase;
    if (!(value >= 0 && value < pattern_period))
        value = pattern_rest(value, pattern_period);
    return value < 0 ? value + 1 : value;
}

/* Wave forms after frequency and phase, all but the ramp on the fraction. */
static double pattern_fold(const struct pattern *pattern, double value)
{
    double v = pattern_cycle(pattern, value);
    if (pattern->wave == WAVE_RAMP)
        return v;
    if (v > 1)
        v -= floor(v);
    switch (pattern->wave) {
    case WAVE_RAMP:
        break;
    case WAVE_TRIANGLE:
        return v < 0.5 ? 2 * v : 2 * (1 - v);
    case WAVE_SINE:
        return 0.5 * (1 + sin(2 * M_PI * v));
    case WAVE_SCALLOP:
        return fabs(sin(M_PI * v));
    case WAVE_CUBIC:
        return v * v * (3 - 2 * v);
    case WAVE_POLY:
        return power_of(v, pattern->exponent);
    }
    return v;
}

double pattern_value_at(const struct pattern *pattern, vec3 located)
{
    return pattern_value_seen(pattern, located, NULL);
}

/* From the value of a kind's pattern to that of this one. */
static inline double pattern_finish(const struct pattern *pattern, double value)
{
    if (pattern->kind->blocks == 0)
        value = pattern_fold(pattern, value);
    return isfinite(value) ? value : 0;
}

/* Most patterns are a ramp, and most values in its first cycle: the same of
 * values that all are. False, and they are left alone, if some are not, or
 * spots no places. */
CLONES static bool values_keep(double frequency, double phase,
                               const struct spots *restrict spots,
                               double *restrict values)
{
    int64_t kept = -1;
    double all[SPOTS_MAX];
    for (int i = 0; i < spots->count; i++) {
        double value = values[i] * frequency + phase;
        double none = (spots->x[i] - spots->x[i]) +
                      (spots->y[i] - spots->y[i]) + (spots->z[i] - spots->z[i]);
        all[i] = value;
        kept &=
            -(int64_t)((value >= 0) & (value < pattern_period) & (none == 0));
    }
    for (int i = 0; kept && i < spots->count; i++)
        values[i] = all[i];
    return kept;
}

static void values_finish(const struct pattern *pattern,
                          const struct spots *located, double *values)
{
    bool ramp = pattern->kind->blocks == 0 && pattern->wave == WAVE_RAMP &&
                pattern->frequency != 0;
    if (ramp &&
        values_keep(pattern->frequency, pattern->phase, located, values))
        return;
    for (int i = 0; i < located->count; i++)
        values[i] = vec3_finite(spots_at(located, i))
                        ? pattern_finish(pattern, values[i])
                        : 0;
}

/* Places that are no numbers are no places: no kind is asked about them. */
static void pattern_values_each(const struct pattern *pattern,
                                const struct spots *located, double *values)
{
    for (int i = 0; i < located->count; i++) {
        vec3 spot = spots_at(located, i);
        values[i] = vec3_finite(spot) ? pattern->kind->value(pattern, spot) : 0;
    }
}

void pattern_values_at(const struct pattern *pattern,
                       const struct spots *located, double *values)
{
    if (!pattern->kind) {
        for (int i = 0; i < located->count; i++)
            values[i] = 0;
        return;
    }
    if (pattern->kind->values)
        pattern->kind->values(pattern, located, values);
    else
        pattern_values_each(pattern, located, values);
    values_finish(pattern, located, values);
}

static double pattern_raw(const struct pattern *pattern, vec3 located)
{
    const struct pattern_kind *kind = pattern->kind;
    if (kind->value)
        return kind->value(pattern, located);
    struct spots spots = spots_of(located);
    double value;
    kind->values(pattern, &spots, &value);
    return value;
}

bool pattern_is_of_space(const struct pattern *pattern, int *budget)
{
    const struct pattern_kind *kind = pattern->kind;
    if (pattern->uv)
        return false;
    if (!kind || !kind->seen)
        return true;
    return kind->of_space && kind->of_space(pattern, budget);
}

double pattern_value_seen(const struct pattern *pattern, vec3 located,
                          const struct uv_source *surface)
{
    if (!pattern->kind || !vec3_finite(located))
        return 0;
    double value = surface && pattern->kind->seen
                       ? pattern->kind->seen(pattern, located, surface)
                       : pattern_raw(pattern, located);
    return pattern_finish(pattern, value);
}

double pattern_value(const struct pattern *pattern, vec3 point)
{
    return pattern_value_at(pattern, pattern_locate(pattern, point));
}
