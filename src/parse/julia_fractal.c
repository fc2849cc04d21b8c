/* julia_fractal{} */
#include "scene/julia_fractal.h"

#include "parse/rules.h"

/* julia_slice = "slice" vector [","] float . */
static bool parse_julia_slice(struct parser *p, struct julia_fractal *fractal)
{
    stream_next(p);
    if (!parse_components(p, fractal->slice, 4))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_float(p, &fractal->slice[4]);
}

/* julia_power = "(" float [","] float ")" . */
static bool parse_julia_power(struct parser *p, struct julia_fractal *fractal)
{
    struct span open = stream_span(p);
    if (!expect(p, TOKEN_LPAREN, span_none()) ||
        !parse_float(p, &fractal->power[0]))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_float(p, &fractal->power[1]) && expect(p, TOKEN_RPAREN, open);
}

/* julia_function = "sqr" | "cube" | "exp" | "reciprocal" | "sin" | "asin"
 *                | "sinh" | "asinh" | "cos" | "acos" | "cosh" | "acosh"
 *                | "tan" | "atan" | "tanh" | "atanh" | "ln"
 *                | "pwr" julia_power .
 * They are rows of scene/julia_function.c. */
static enum taken parse_julia_function(struct parser *p,
                                       struct julia_fractal *fractal)
{
    const struct token *token = stream_peek(p);
    const struct julia_function *function =
        token->kind == TOKEN_WORD ? julia_function_find(token->word->text)
                                  : NULL;
    if (!function)
        return NOT_MINE;
    stream_next(p);
    fractal->function = function;
    fractal->cube = strcmp(function->name, "cube") == 0;
    return strcmp(function->name, "pwr") != 0 || parse_julia_power(p, fractal);
}

/* julia_item = "quaternion" | "hypercomplex" | julia_function | julia_slice
 *            | JULIA_ITEM .
 * The last are in the table of src/scene/julia_fractal.c. */
static enum taken parse_julia_item(struct parser *p,
                                   struct julia_fractal *fractal)
{
    const struct field *field = accept_field(p, julia_fractal_primitive.items);
    if (field)
        return parse_field(p, field, fractal);
    if (accept_keyword(p, KEYWORD_QUATERNION))
        fractal->algebra = JULIA_QUATERNION;
    else if (accept_keyword(p, KEYWORD_HYPERCOMPLEX))
        fractal->algebra = JULIA_HYPERCOMPLEX;
    else if (stream_keyword(p) == KEYWORD_SLICE)
        return parse_julia_slice(p, fractal);
    else
        return parse_julia_function(p, fractal);
    return TAKEN;
}

/* julia_body = vector {julia_item} . */
static bool parse_julia_body(struct parser *p, void *shape)
{
    struct julia_fractal *fractal = shape;
    struct span span = stream_span(p);
    enum taken taken;
    julia_fractal_init(fractal);
    if (!parse_components(p, fractal->c, 4))
        return false;
    do
        taken = parse_julia_item(p, fractal);
    while (taken == TAKEN);
    if (taken == WRONG)
        return false;
    const char *name = fractal->function->name;
    if (fractal->algebra == JULIA_QUATERNION && strcmp(name, "sqr") != 0 &&
        !fractal->cube)
        return error_at(p, span_join(span, p->last_span), "hypercomplex",
                        "a quaternion Julia set is of 'sqr' or 'cube', found "
                        "'%s'",
                        name);
    return true;
}

/* julia_fractal = "julia_fractal" "{" julia_body {modifier} "}" . */
bool parse_julia_fractal(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &julia_fractal_primitive, parse_julia_body);
}
