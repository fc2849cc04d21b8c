/* Patterns: the list, where they are evaluated, and how raw values are folded
 * into [0,1]. All constants were measured with POV-Ray 3.7. */
#include "scene/pattern.h"

#include "base/listing.h"
#include "scene/noise.h"

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
        .inverse = affine_identity(),
        .wave = kind ? kind->wave : WAVE_RAMP,
        .exponent = 1,
        .frequency = 1,
        .turbulence = { { 0, 0, 0 }, 6, 0.5, 2 },
    };
    if (kind && kind->size) {
        pattern.parameters = arena_alloc(arena, kind->size);
        if (kind->defaults)
            memcpy(pattern.parameters, kind->defaults, kind->size);
    }
    return pattern;
}

void pattern_transform(struct pattern *pattern, const affine *transform)
{
    affine inverse;
    if (affine_inverse(*transform, &inverse))
        pattern->inverse = affine_compose(pattern->inverse, inverse);
}

vec3 pattern_locate(const struct pattern *pattern, vec3 point)
{
    point = affine_point(&pattern->inverse, point);
    if (!pattern->turbulent || (pattern->kind && pattern->kind->own_turbulence))
        return point;
    vec3 step = noise_vector_turbulence(point, &pattern->turbulence);
    return vec3_add(point, vec3_mul(pattern->turbulence.amount, step));
}

/* The period is 1.00001, not 1: with it a value of exactly 1 is the end of a
 * colour map and not its start. frequency 0 leaves values above 1 alone. */
static double pattern_cycle(const struct pattern *pattern, double value)
{
    const double period = 1.00001;
    if (pattern->frequency == 0)
        return value < 0 ? value - floor(value) : value;
    value = value * pattern->frequency + pattern->phase;
    if (!(value >= 0 && value < period))
        value = fmod(value, period);
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
        return pow(v, pattern->exponent);
    }
    return v;
}

double pattern_value_at(const struct pattern *pattern, vec3 located)
{
    if (!pattern->kind || !vec3_finite(located))
        return 0;
    double value = pattern->kind->value(pattern, located);
    if (pattern->kind->blocks == 0)
        value = pattern_fold(pattern, value);
    return isfinite(value) ? value : 0;
}

double pattern_value(const struct pattern *pattern, vec3 point)
{
    return pattern_value_at(pattern, pattern_locate(pattern, point));
}
