/* isosurface{}: a function and what contains it. */
#include "scene/isosurface.h"

#include "parse/rules.h"
#include "parse/user_function.h"
#include "scene/function.h"
#include "scene/samples.h"

/* evaluation = "evaluate" float [","] float [","] float .
 * POV-Ray's guess of the gradient begins with the first. */
static bool parse_evaluation(struct parser *p, struct isosurface *surface)
{
    double numbers[3];
    stream_next(p);
    for (int i = 0; i < 3; i++) {
        if (!parse_float(p, &numbers[i]))
            return false;
        accept(p, TOKEN_COMMA);
    }
    surface->max_gradient = fmax(surface->max_gradient, numbers[0]);
    return true;
}

/* isosurface_item = contained_by | evaluation | ISOSURFACE_ITEM .
 * ISOSURFACE_ITEM is in the table of src/scene/isosurface.c. */
static enum taken parse_isosurface_item(struct parser *p,
                                        struct isosurface *surface)
{
    const struct field *field = accept_field(p, isosurface_primitive.items);
    if (field)
        return parse_field(p, field, surface);
    switch (stream_keyword(p)) {
    case KEYWORD_CONTAINED_BY:
        return parse_contained_by(p, &surface->container);
    case KEYWORD_EVALUATE:
        return parse_evaluation(p, surface);
    default:
        return NOT_MINE;
    }
}

static double surface_sample(const void *function, vec3 point)
{
    return function_sample(function, point);
}

/* isosurface_body = function {isosurface_item} . */
static bool parse_isosurface_body(struct parser *p, void *shape)
{
    struct isosurface *surface = shape;
    struct value value;
    enum taken taken;
    isosurface_init(surface);
    if (stream_keyword(p) != KEYWORD_FUNCTION)
        return error_expected(p, "'function'");
    struct span span = stream_span(p);
    if (!parse_function(p, &value))
        return false;
    surface->function = value.function;
    if (value.function->parameter_count != 3 || value.function->values)
        return error_at(p, span_join(span, p->last_span), NULL,
                        "an isosurface needs a function of x, y and z that "
                        "gives a number");
    if (!stream_round(p, 1000, span)) /* as for a pattern's samples */
        return false;
    surface->samples =
        samples_take(p->scene_arena, surface_sample, surface->function);
    do
        taken = parse_isosurface_item(p, surface);
    while (taken == TAKEN);
    return taken != WRONG;
}

/* isosurface = "isosurface" "{" isosurface_body {modifier} "}" . */
bool parse_isosurface(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &isosurface_primitive, parse_isosurface_body);
}
