/* poly { ORDER, < TERMS > }: an algebraic surface of order 2 to 35. */
#include "scene/algebraic.h"

static const struct field poly_arguments[] = {
    { "order", FIELD_INTEGER, offsetof(struct algebraic, order), 2,
      ALGEBRAIC_ORDER_MAX, "the highest power", false },
    ALGEBRAIC_TERMS("(n+1)(n+2)(n+3)/6 coefficients, of x^n, x^(n-1) y, ... to "
                    "the constant"),
    { .name = NULL },
};

static const char *poly_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct algebraic *surface = shape;
    (void)warning;
    if (surface->order < 2 || surface->order > ALGEBRAIC_ORDER_MAX)
        return "its order is not within 2 and 35";
    return algebraic_check(surface, arena);
}

const struct primitive poly_primitive = {
    .name = "poly",
    .help = "an algebraic surface of any order up to 35",
    .arguments = poly_arguments,
    .prepare = poly_prepare,
    ALGEBRAIC_SHAPE,
};
