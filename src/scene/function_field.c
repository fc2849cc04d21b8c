/* Fields of functions: see function_field.h. */
#include "scene/function_field.h"

#include "scene/material.h"
#include "scene/noise.h"

static double pattern_field(const struct function_field *field, vec3 point)
{
    return pattern_value(field->thing, point);
}

static double pigment_field(const struct function_field *field, vec3 point)
{
    colour c = pigment_colour(field->thing, point);
    const double parts[] = { c.r, c.g, c.b, c.filter, c.transmit };
    return field->part < FIELD_GREY ? parts[field->part]
                                    : 0.297 * c.r + 0.589 * c.g + 0.114 * c.b;
}

const struct function_field *field_of_pattern(struct arena *arena,
                                              const struct pattern *pattern)
{
    struct function_field *field = ARENA_NEW(arena, struct function_field);
    struct pattern *kept = ARENA_NEW(arena, struct pattern);
    *kept = *pattern;
    *field = (struct function_field){ pattern_field, kept, 0 };
    return field;
}

const struct function_field *
field_of_pigment(struct arena *arena, const struct pigment *pigment, int part)
{
    struct function_field *field = ARENA_NEW(arena, struct function_field);
    *field = (struct function_field){ pigment_field, pigment, part };
    return field;
}

/* ---- functions.inc; a[0..2] are x, y, z; formulas measured ---- */

static double internal_r(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static double internal_sphere(const double *a)
{
    return internal_r(a) - a[3];
}

static double internal_theta(const double *a)
{
    return atan2(a[0], a[2]);
}

static double internal_phi(const double *a)
{
    return atan2(sqrt(a[0] * a[0] + a[2] * a[2]), a[1]);
}

static double internal_ellipsoid(const double *a)
{
    double x = a[0] * a[3], y = a[1] * a[4], z = a[2] * a[5];
    return sqrt(x * x + y * y + z * z);
}

/* How far outside of the box that is smaller by the radius of its edges, less
 * that radius. */
static double internal_rounded_box(const double *a)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double side = fabs(a[i]) - (a[4 + i] - a[3]);
        sum += side > 0 ? side * side : 0;
    }
    return sqrt(sum) - a[3];
}

static double internal_torus(const double *a)
{
    double ring = sqrt(a[0] * a[0] + a[2] * a[2]) - a[3];
    return sqrt(ring * ring + a[1] * a[1]) - a[4];
}

static double internal_superellipsoid(const double *a)
{
    double east = 2 / a[3], north = 2 / a[4];
    double round = pow(fabs(a[0]), east) + pow(fabs(a[1]), east);
    double norm = pow(round, a[3] / a[4]) + pow(fabs(a[2]), north);
    return 1 - pow(norm, a[4] / 2);
}

static double internal_noise_generator(const double *a)
{
    int generator = a[3] < 1.5 ? 1 : a[3] < 2.5 ? 2 : 3;
    return noise_value(generator, vec3_make(a[0], a[1], a[2]));
}

const struct internal_function *internal_find(int number)
{
    static const struct internal_function functions[] = {
        { 17, 6, internal_ellipsoid },
        { 47, 3, internal_phi },
        { 57, 3, internal_r },
        { 60, 7, internal_rounded_box },
        { 61, 4, internal_sphere },
        { 68, 5, internal_superellipsoid },
        { 69, 3, internal_theta },
        { 70, 5, internal_torus },
        { 78, 4, internal_noise_generator },
    };
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (functions[i].number == number)
            return &functions[i];
    return NULL;
}
