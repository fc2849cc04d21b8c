/* parametric{}: three functions of u and v. */
#include "scene/parametric.h"

#include "parse/rules.h"
#include "parse/user_function.h"
#include "scene/function.h"

static bool parse_coordinate(struct parser *p, const struct function **out)
{
    struct value value;
    struct span span = stream_span(p);
    if (stream_keyword(p) != KEYWORD_FUNCTION)
        return error_expected(p, "'function': one each for x, y and z");
    if (!parse_function(p, &value))
        return false;
    accept(p, TOKEN_COMMA);
    *out = value.function;
    return (value.function->parameter_count <= 3 && !value.function->values) ||
           error_at(p, span_join(span, p->last_span), NULL,
                    "a parametric surface needs functions of u and v that "
                    "give a number");
}

/* precompute = "precompute" float [","] {( "x" | "y" | "z" ) [","]} .
 * What POV-Ray works out beforehand; glim does so anyway. */
static bool parse_precompute(struct parser *p)
{
    double depth;
    stream_next(p);
    if (!parse_float(p, &depth))
        return false;
    do
        accept(p, TOKEN_COMMA);
    while (accept_keyword(p, KEYWORD_X) || accept_keyword(p, KEYWORD_Y) ||
           accept_keyword(p, KEYWORD_Z));
    return true;
}

/* parametric_item = contained_by | precompute | PARAMETRIC_ITEM .
 * The last are in the table of src/scene/parametric.c. */
static enum taken parse_parametric_item(struct parser *p,
                                        struct parametric *surface)
{
    const struct field *field = accept_field(p, parametric_primitive.items);
    if (field)
        return parse_field(p, field, surface);
    if (stream_keyword(p) == KEYWORD_CONTAINED_BY)
        return parse_contained_by(p, &surface->container);
    if (stream_keyword(p) == KEYWORD_PRECOMPUTE)
        return parse_precompute(p);
    return NOT_MINE;
}

/* parametric_body = function [","] function [","] function [","] vector [","]
 *                   vector {parametric_item} . */
static bool parse_parametric_body(struct parser *p, void *shape)
{
    enum { ROUNDS = 10000 }; /* of a loop, as long as it takes to prepare one */
    struct parametric *surface = shape;
    struct span span = stream_span(p);
    enum taken taken;
    parametric_init(surface);
    for (int i = 0; i < 3; i++)
        if (!parse_coordinate(p, &surface->coordinate[i]))
            return false;
    if (!parse_components(p, surface->from, 2))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_components(p, surface->to, 2) || !stream_round(p, ROUNDS, span))
        return false;
    do
        taken = parse_parametric_item(p, surface);
    while (taken == TAKEN);
    return taken != WRONG;
}

/* parametric = "parametric" "{" parametric_body {modifier} "}" . */
bool parse_parametric(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &parametric_primitive, parse_parametric_body);
}
