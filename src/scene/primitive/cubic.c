/* cubic { < 20 TERMS > }: an algebraic surface of order 3. */
#include "scene/algebraic.h"

static const struct field cubic_arguments[] = {
    { "terms", FIELD_TERMS, offsetof(struct algebraic, terms), 0, 0,
      "20 coefficients, of x^3, x^2 y, ... to the constant", false },
    { .name = NULL },
};

static const struct field cubic_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct algebraic, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
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
    .size = sizeof(struct algebraic),
    .arguments = cubic_arguments,
    .items = cubic_items,
    .solid = true,
    .bounded = BOUNDS_AS_SHAPE,
    .prepare = cubic_prepare,
    .bounds = algebraic_shape_bounds,
    .intersect = algebraic_shape_intersect,
    .crossings = algebraic_shape_crossings,
    .crosses = algebraic_shape_crosses,
    .first = algebraic_shape_first,
    .normal = algebraic_shape_normal,
    .inside = algebraic_shape_inside,
    .meets = algebraic_shape_meets,
};
