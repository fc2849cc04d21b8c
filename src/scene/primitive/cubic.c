/* cubic { < 20 TERMS > }: an algebraic surface of order 3. */
#include "scene/algebraic.h"

static const struct field cubic_arguments[] = {
    ALGEBRAIC_TERMS("20 coefficients, of x^3, x^2 y, ... to the constant"),
    { .name = NULL },
};

static const char *cubic_prepare(void *shape, struct arena *arena,
                                 const char **warning)
{
    struct algebraic *surface = shape;
    (void)warning;
    surface->order = 3;
    return algebraic_check(surface, arena);
}

const struct primitive cubic_primitive = {
    .name = "cubic",
    .help = "an algebraic surface of order 3",
    .arguments = cubic_arguments,
    .prepare = cubic_prepare,
    ALGEBRAIC_SHAPE,
};
