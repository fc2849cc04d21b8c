/* Functions of vectors and of the extent of objects. */
#include "base/affine.h"
#include "parse/expression.h"
#include "parse/function.h"
#include "parse/symbol.h"
#include "scene/noise.h"
#include "scene/object_probe.h"

static vec3 argument(const struct call *call, int i)
{
    const double *n = call->arguments[i].number;
    return vec3_make(n[0], n[1], n[2]);
}

void vector_dot(struct parser *p, const struct call *call, struct value *result)
{
    (void)p;
    *result = value_float(vec3_dot(argument(call, 0), argument(call, 1)));
}

void vector_length(struct parser *p, const struct call *call,
                   struct value *result)
{
    (void)p;
    *result = value_float(vec3_length(argument(call, 0)));
}

void vector_cross(struct parser *p, const struct call *call,
                  struct value *result)
{
    (void)p;
    *result = value_vector(vec3_cross(argument(call, 0), argument(call, 1)));
}

void vector_normalise(struct parser *p, const struct call *call,
                      struct value *result)
{
    vec3 v = argument(call, 0);
    if (vec3_length(v) == 0)
        warning_at(p, call->span, NULL,
                   "a vector of length 0 can't be normalised; it stays");
    *result = value_vector(vec3_normalise(v));
}

void vector_rotate(struct parser *p, const struct call *call,
                   struct value *result)
{
    (void)p;
    affine rotation = affine_rotation(argument(call, 1));
    *result = value_vector(affine_direction(&rotation, argument(call, 0)));
}

void vector_axis_rotate(struct parser *p, const struct call *call,
                        struct value *result)
{
    (void)p;
    affine rotation =
        affine_axis_rotation(argument(call, 1), call->arguments[2].number[0]);
    *result = value_vector(affine_direction(&rotation, argument(call, 0)));
}

/* vturbulence(lambda, omega, octaves, point) */
void vector_turbulence(struct parser *p, const struct call *call,
                       struct value *result)
{
    (void)p;
    const struct value *a = call->arguments;
    int octaves = float_to_int(a[2].number[0]);
    struct turbulence turbulence = {
        .amount = { 1, 1, 1 },
        .octaves = octaves < 1    ? 1
                   : octaves > 10 ? 10
                                  : octaves,
        .omega = a[1].number[0],
        .lambda = a[0].number[0],
    };
    *result =
        value_vector(noise_vector_turbulence(argument(call, 3), &turbulence));
}

/* Objects without end have corners at 1e10, as in POV-Ray (measured). */
static double extent_finite(double x)
{
    return fmax(-1e10, fmin(1e10, x));
}

static struct value extent_corner(vec3 v)
{
    return value_vector(
        vec3_make(extent_finite(v.x), extent_finite(v.y), extent_finite(v.z)));
}

void vector_min_extent(struct parser *p, const struct call *call,
                       struct value *result)
{
    (void)p;
    *result = extent_corner(object_bounds(call->object).low);
}

void vector_max_extent(struct parser *p, const struct call *call,
                       struct value *result)
{
    (void)p;
    *result = extent_corner(object_bounds(call->object).high);
}

void vector_inside(struct parser *p, const struct call *call,
                   struct value *result)
{
    object_probe_expect(call->object, false, p->scene_arena);
    if (object_is_solid(call->object))
        *result = value_float(object_inside(call->object, argument(call, 1)));
    else
        call_error(p, call, result, NULL,
                   "inside() wants an object that has an inside");
}

/* trace(object, origin, direction, normal): the point, and the normal into the
 * identifier; all zero if nothing is met. */
void vector_trace(struct parser *p, const struct call *call,
                  struct value *result)
{
    struct ray ray = { argument(call, 1), vec3_normalise(argument(call, 2)) };
    double t;
    vec3 normal, point = vec3_make(0, 0, 0);
    object_probe_expect(call->object, false, p->scene_arena);
    if (object_trace(call->object, &ray, &t, &normal))
        point = ray_point(&ray, t);
    *result = value_vector(point);
    if (call->target) {
        struct value given = value_vector(normal);
        symbol_give(p, call->target, &given);
    }
}
