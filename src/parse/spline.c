/* spline { }: see spline.h. */
#include "parse/spline.h"

#include <string.h>

#include "parse/expression.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "scene/spline.h"

enum { SPLINE_LIMIT = 1000000 }; /* points of one */

/* spline_type = "linear_spline" | "quadratic_spline" | "cubic_spline"
 *             | "natural_spline" . */
static bool parse_spline_type(struct parser *p, enum spline_kind *kind)
{
    switch (stream_keyword(p)) {
    case KEYWORD_LINEAR_SPLINE:
        *kind = SPLINE_LINEAR;
        break;
    case KEYWORD_QUADRATIC_SPLINE:
        *kind = SPLINE_QUADRATIC;
        break;
    case KEYWORD_CUBIC_SPLINE:
        *kind = SPLINE_CUBIC;
        break;
    case KEYWORD_NATURAL_SPLINE:
        *kind = SPLINE_NATURAL;
        break;
    default:
        return false;
    }
    stream_next(p);
    return true;
}

static bool spline_number(struct parser *p, struct span start, double number)
{
    return isfinite(number) ||
           error_at(p, span_join(start, p->last_span), NULL,
                    "a time or place of a spline is not a finite number");
}

/* Numbers that it doesn't have are those of the point written before it
 * (measured): `place`.
 * spline_point = float [","] operation [","] . */
static bool parse_spline_point(struct parser *p, struct spline *spline,
                               double place[SPLINE_SIZE])
{
    struct spline_knot knot = { 0 };
    struct value value;
    struct span start = stream_span(p);
    if (stream_peek(p)->kind == TOKEN_LESS)
        return error_expected_hint(p, "a number, the time of the point",
                                   "0, <1, 2, 3>");
    if (!parse_float(p, &knot.time)) {
        note_unclosed(p);
        return false;
    }
    accept(p, TOKEN_COMMA);
    if (!spline_number(p, start, knot.time))
        return false;
    start = stream_span(p);
    if (!parse_operation(p, PRECEDENCE_SUM, "a vector", &value) ||
        value_is_poison(&value))
        return false;
    if (value_size(&value) == 0)
        return error_at(p, span_join(start, p->last_span), NULL,
                        "expected a vector, found %s", value_describe(&value));
    if (value.kind == VALUE_FLOAT)
        value_promote(&value, 2);
    for (int i = 0; i < value_size(&value); i++) {
        place[i] = value.number[i];
        if (!spline_number(p, start, place[i]))
            return false;
    }
    memcpy(knot.place, place, sizeof knot.place);
    if (spline->size < value_size(&value))
        spline->size = value_size(&value);
    accept(p, TOKEN_COMMA);
    if (spline->knots.count == SPLINE_LIMIT)
        return error_at(p, start, NULL,
                        "a spline has more than %d points, glim's limit",
                        SPLINE_LIMIT);
    *ARRAY_PUSH(p->scene_arena, &spline->knots) = knot;
    return true;
}

/* A declared one is copied, for points may be added. */
static void spline_copy(struct parser *p, struct spline *spline)
{
    const struct value *value = accept_value(p, VALUE_SPLINE);
    if (!value)
        return;
    const struct spline *from = value->spline;
    spline->kind = from->kind;
    spline->size = from->size;
    for (size_t i = 0; i < from->knots.count; i++) {
        struct spline_knot *knot = ARRAY_PUSH(p->scene_arena, &spline->knots);
        *knot = from->knots.items[i];
    }
}

/* `natural` is short for natural_spline to some. */
static const char *spline_type_hint(struct parser *p)
{
    static const enum keyword types[] = { KEYWORD_LINEAR_SPLINE,
                                          KEYWORD_QUADRATIC_SPLINE,
                                          KEYWORD_CUBIC_SPLINE,
                                          KEYWORD_NATURAL_SPLINE };
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return NULL;
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        const char *name = keyword_spelling(types[i]);
        if (strncmp(name, token->word->text, token->word->length) == 0)
            return name;
    }
    return NULL;
}

static bool spline_points(struct parser *p, struct spline *spline)
{
    spline_copy(p, spline);
    double place[SPLINE_SIZE] = { 0 };
    if (!parse_spline_type(p, &spline->kind)) {
        const char *hint = spline_type_hint(p);
        if (hint)
            return error_expected_hint(p, "the type of a spline", hint);
    }
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_spline_point(p, spline, place))
            return false;
    return spline->knots.count > 0 ||
           error_expected(p, "a point of the spline");
}

/* spline = "spline" "{" [SPLINE] [spline_type] {spline_point} "}" . */
bool parse_spline(struct parser *p, const struct spline **out)
{
    struct spline *spline = ARENA_NEW(p->scene_arena, struct spline);
    struct span open;
    struct cursor *outer = brackets_begin(p);
    stream_next(p);
    spline->size = 2;
    bool ok =
        block_begin(p, &open) && block_end(p, open, spline_points(p, spline));
    if (ok)
        spline_prepare(spline, p->scene_arena);
    *out = spline;
    return brackets_end(p, outer, ok);
}

static bool call_arguments(struct parser *p, double *time,
                           enum spline_kind *kind)
{
    struct span open = stream_span(p);
    stream_next(p);
    if (!parse_float(p, time))
        return false;
    if (accept(p, TOKEN_COMMA) && !parse_spline_type(p, kind))
        return error_expected(p, "the type of a spline");
    return expect(p, TOKEN_RPAREN, open);
}

/* spline_call = SPLINE "(" float ["," spline_type] ")" . */
bool spline_call(struct parser *p, const struct spline *spline,
                 const struct word *name, struct value *value)
{
    enum spline_kind kind = spline->kind;
    double time;
    if (stream_peek_infix(p)->kind != TOKEN_LPAREN)
        return error_expected(
            p, arena_printf(p->arena, "'(' after '%s'", name->text));
    struct cursor *outer = brackets_begin(p);
    if (!brackets_end(p, outer, call_arguments(p, &time, &kind)))
        return false;
    *value = (struct value){ .kind = VALUE_VECTOR, .size = spline->size };
    spline_at(spline, kind, time, value->number);
    return true;
}
