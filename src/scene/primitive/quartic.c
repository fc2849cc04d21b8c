/* quartic { < 35 TERMS > }: an algebraic surface of order 4. */
#include "scene/algebraic.h"

static const struct field quartic_arguments[] = {
    ALGEBRAIC_TERMS("35 coefficients, of x^4, x^3 y, ... to the constant"),
    { .name = NULL },
};

static const char *quartic_prepare(void *shape, struct arena *arena,
                                   const char **warning)
{
    struct algebraic *surface = shape;
    (void)warning;
    surface->order = 4;
    return algebraic_check(surface, arena);
}

const struct primitive quartic_primitive = {
    .name = "quartic",
    .help = "an algebraic surface of order 4",
    .arguments = quartic_arguments,
    .prepare = quartic_prepare,
    ALGEBRAIC_SHAPE,
};
