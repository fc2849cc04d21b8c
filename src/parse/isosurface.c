/* isosurface{}: a function and what contains it. */
#include "scene/isosurface.h"

#include "parse/rules.h"
#include "parse/user_function.h"
#include "scene/function.h"
#include "scene/samples.h"

/* Chords on which the gradient is measured: to say that it is too low, and to
 * find it. */
enum { CHORDS_TOLD = 64, CHORDS_FOUND = 512 };

/* While it is read. */
struct isosurface_reading {
    struct isosurface *surface;
    double least, factor; /* of what is measured, if evaluate says so, else 0 */
};

/* evaluation = "evaluate" float [","] float [","] float .
 * POV-Ray raises the first by the second as rays meet larger gradients. */
static bool parse_evaluation(struct parser *p, struct isosurface_reading *in)
{
    double numbers[3];
    stream_next(p);
    for (int i = 0; i < 3; i++) {
        if (!parse_float(p, &numbers[i]))
            return false;
        accept(p, TOKEN_COMMA);
    }
    in->least = numbers[0];
    in->factor = fmax(numbers[1], 1);
    return true;
}

/* isosurface_item = contained_by | evaluation | ISOSURFACE_ITEM .
 * ISOSURFACE_ITEM is in the table of src/scene/isosurface.c. */
static enum taken parse_isosurface_item(struct parser *p,
                                        struct isosurface_reading *in)
{
    struct isosurface *surface = in->surface;
    const struct field *field = accept_field(p, isosurface_primitive.items);
    if (field)
        return parse_field(p, field, surface);
    switch (stream_keyword(p)) {
    case KEYWORD_CONTAINED_BY:
        return parse_contained_by(p, &surface->container);
    case KEYWORD_EVALUATE:
        return parse_evaluation(p, in);
    default:
        return NOT_MINE;
    }
}

/* What rays need to find all of the surface: chords miss the largest. */
static double gradient_needed(const struct isosurface *surface, double factor)
{
    return isosurface_gradient(surface, CHORDS_FOUND) * fmax(factor, 1.25);
}

static bool find_gradient(struct parser *p, struct span span,
                          const struct isosurface_reading *in)
{
    struct isosurface *surface = in->surface;
    double said = surface->max_gradient;
    bool finds = in->factor > 0;
    int chords = finds ? CHORDS_FOUND : CHORDS_TOLD;
    if (!stream_round(p, (unsigned)chords * 16, span)) /* two values each */
        return false;
    if (finds)
        surface->max_gradient =
            fmax(fmax(said, in->least), gradient_needed(surface, in->factor));
    else if (said > 0 && isosurface_gradient(surface, chords) > 1.1 * said)
        warning_at(p, span,
                   arena_printf(p->arena, "max_gradient %.2g",
                                gradient_needed(surface, 1)),
                   "the function changes faster than by its max_gradient, %g a "
                   "unit: rays miss parts of the surface",
                   said);
    return true;
}

static double surface_sample(const void *function, vec3 point)
{
    return function_sample(function, point);
}

/* isosurface_body = function {isosurface_item} . */
static bool parse_isosurface_body(struct parser *p, void *shape)
{
    struct isosurface *surface = shape;
    struct isosurface_reading in = { .surface = surface };
    struct value value;
    enum taken taken;
    isosurface_init(surface);
    if (stream_keyword(p) != KEYWORD_FUNCTION)
        return error_expected_hint(p, "'function'", "function { ... }");
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
        taken = parse_isosurface_item(p, &in);
    while (taken == TAKEN);
    return taken != WRONG && find_gradient(p, span, &in);
}

/* isosurface = "isosurface" "{" isosurface_body {modifier} "}" . */
bool parse_isosurface(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &isosurface_primitive, parse_isosurface_body);
}
