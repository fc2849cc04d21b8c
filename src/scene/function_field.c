/* Fields of functions: see function_field.h. */
#include "scene/function_field.h"

#include "scene/material.h"
#include "scene/noise.h"
#include "scene/spline.h"
#include "scene/spots.h"

static double pattern_field(const struct function_field *field, vec3 point)
{
    return pattern_value(field->thing, point);
}

static void pattern_field_values(const struct function_field *field,
                                 const struct spots *spots, double *values)
{
    struct spots located;
    pattern_locate_all(field->thing, spots, &located);
    pattern_values_at(field->thing, &located, values);
}

const struct function_field *field_of_pattern(struct arena *arena,
                                              const struct pattern *pattern)
{
    struct function_field *field = ARENA_NEW(arena, struct function_field);
    struct pattern *kept = ARENA_NEW(arena, struct pattern);
    bool together = pattern->kind && pattern->kind->values;
    *kept = *pattern;
    *field = (struct function_field){ .value = pattern_field,
                                      .values = together ? pattern_field_values
                                                         : NULL,
                                      .thing = kept };
    return field;
}

static double noise_field(const struct function_field *field, vec3 point)
{
    const struct noise_settings *settings = field->thing;
    return vec3_finite(point) ? noise_value(settings->generator, point) : 0;
}

static void noise_field_values(const struct function_field *field,
                               const struct spots *spots, double *values)
{
    const struct noise_settings *settings = field->thing;
    noise_values(settings->generator, spots, values);
    for (int i = 0; i < spots->count; i++)
        values[i] = vec3_finite(spots_at(spots, i)) ? values[i] : 0;
}

const struct function_field *field_of_noise(struct arena *arena,
                                            const struct noise_settings *noise)
{
    struct function_field *field = ARENA_NEW(arena, struct function_field);
    *field =
        (struct function_field){ noise_field, noise_field_values, noise, 0 };
    return field;
}

/* ---- several values ---- */

static double part_of(const double parts[5], int part)
{
    if (part == FIELD_GREY)
        return grey_of(parts[0], parts[1], parts[2]);
    if (part == FIELD_HEIGHT)
        return (parts[0] + parts[1] / 255) * 0.996093; /* measured */
    return parts[part];
}

static double values_part(const struct function_field *field, vec3 point)
{
    const struct function_values *values = field->thing;
    double parts[5];
    values->at(values, point, parts);
    return part_of(parts, field->part);
}

void function_values_all(const struct function_values *values,
                         const struct spots *spots, double (*parts)[5])
{
    if (values->all)
        values->all(values, spots, parts);
    else
        for (int i = 0; i < spots->count; i++)
            values->at(values, spots_at(spots, i), parts[i]);
}

static void values_parts(const struct function_field *field,
                         const struct spots *spots, double *of)
{
    double parts[SPOTS_MAX][5];
    function_values_all(field->thing, spots, parts);
    for (int i = 0; i < spots->count; i++)
        of[i] = part_of(parts[i], field->part);
}

const struct function_field *
field_of_values(struct arena *arena, const struct function_values *values,
                int part)
{
    struct function_field *field = ARENA_NEW(arena, struct function_field);
    *field =
        (struct function_field){ .value = values_part,
                                 .values = values->all ? values_parts : NULL,
                                 .thing = values,
                                 .part = part };
    return field;
}

static const struct function_values *values_new(struct arena *arena,
                                                struct function_values values)
{
    struct function_values *kept = ARENA_NEW(arena, struct function_values);
    *kept = values;
    return kept;
}

static void colour_parts(colour c, double parts[5])
{
    parts[0] = c.r;
    parts[1] = c.g;
    parts[2] = c.b;
    parts[3] = c.filter;
    parts[4] = c.transmit;
}

static void pigment_values(const struct function_values *values, vec3 point,
                           double parts[5])
{
    colour_parts(pigment_colour(values->thing, point), parts);
}

static void pigment_values_all(const struct function_values *values,
                               const struct spots *spots, double (*parts)[5])
{
    colour colours[SPOTS_MAX];
    pigment_colours(values->thing, spots, colours);
    for (int i = 0; i < spots->count; i++)
        colour_parts(colours[i], parts[i]);
}

const struct function_values *values_of_pigment(struct arena *arena,
                                                const struct pigment *pigment)
{
    return values_new(arena, (struct function_values){ pigment_values,
                                                       pigment_values_all,
                                                       pigment, 5, true });
}

static void spline_values(const struct function_values *values, vec3 point,
                          double parts[5])
{
    const struct spline *spline = values->thing;
    spline_at(spline, spline->kind, point.x, parts);
}

const struct function_values *values_of_spline(struct arena *arena,
                                               const struct spline *spline)
{
    return values_new(arena,
                      (struct function_values){ spline_values, NULL, spline,
                                                spline->size, false });
}

static void affine_values(const struct function_values *values, vec3 point,
                          double parts[5])
{
    vec3 moved = affine_point(values->thing, point);
    parts[0] = moved.x;
    parts[1] = moved.y;
    parts[2] = moved.z;
    parts[3] = parts[4] = 0;
}

const struct function_values *values_of_affine(struct arena *arena,
                                               const affine *transform)
{
    affine *kept = ARENA_NEW(arena, affine);
    *kept = *transform;
    return values_new(
        arena, (struct function_values){ affine_values, NULL, kept, 3, false });
}
