/* polynomial{}: an algebraic surface by the powers of its terms. */
#include "parse/rules.h"
#include "scene/algebraic.h"

/* Where the term of x^i y^j z^k stands among those of the order: behind all of
 * higher powers of x, then of y, then of z. */
static size_t term_place(int order, int i, int j, int k)
{
    size_t x = (size_t)(order - i), y = x - (size_t)j;
    return x * (x + 1) * (x + 2) / 6 + y * (y + 1) / 2 + y - (size_t)k;
}

/* polynomial_term = "xyz" "(" float "," float "," float ")" ":" float [","] .
 */
static bool parse_polynomial_term(struct parser *p, struct algebraic *surface)
{
    int powers[3];
    struct span start = stream_span(p), open;
    double number;
    stream_next(p);
    open = stream_span(p);
    if (!expect(p, TOKEN_LPAREN, span_none()))
        return false;
    for (int i = 0; i < 3; i++)
        if ((i > 0 && !expect(p, TOKEN_COMMA, span_none())) ||
            !parse_integer(p, &powers[i]))
            return false;
    if (!expect(p, TOKEN_RPAREN, open))
        return false;
    int i = powers[0], j = powers[1], k = powers[2], n = surface->order;
    if (i < 0 || j < 0 || k < 0 || i > n || j > n - i || k > n - i - j)
        return error_at(p, span_join(start, p->last_span), NULL,
                        "the powers of a term must be from 0 to the order, %d, "
                        "and no more together",
                        n);
    if (!expect(p, TOKEN_COLON, span_none()))
        return false;
    start = stream_span(p);
    if (!parse_float(p, &number))
        return false;
    if (!isfinite(number))
        return error_at(p, span_join(start, p->last_span), NULL,
                        "this is not a finite number");
    surface->terms.values[term_place(n, i, j, k)] = number;
    accept(p, TOKEN_COMMA);
    return true;
}

/* polynomial_body = float [","] {polynomial_term} . */
static bool parse_polynomial_body(struct parser *p, void *shape)
{
    struct algebraic *surface = shape;
    struct span start = stream_span(p);
    if (!parse_integer(p, &surface->order))
        return false;
    if (surface->order < 2 || surface->order > ALGEBRAIC_ORDER_MAX)
        return error_at(p, start, NULL,
                        "the order must be from 2 to %d, found %d",
                        ALGEBRAIC_ORDER_MAX, surface->order);
    accept(p, TOKEN_COMMA);
    size_t count = algebraic_terms(surface->order);
    surface->terms.values = ARENA_ARRAY(p->scene_arena, double, count);
    surface->terms.count = count;
    while (at_word(p, "xyz"))
        if (!parse_polynomial_term(p, surface))
            return false;
    return true;
}

/* polynomial = "polynomial" "{" polynomial_body {modifier} "}" . */
bool parse_polynomial(struct parser *p, struct object **out)
{
    return parse_shape(p, out, primitive_find("poly"), parse_polynomial_body);
}
