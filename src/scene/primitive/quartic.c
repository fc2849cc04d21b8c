/* quartic { < 35 TERMS > }: an algebraic surface of order 4. */
#include "scene/algebraic.h"

static const struct field quartic_arguments[] = {
    { "terms", FIELD_TERMS, offsetof(struct algebraic, terms), 0, 0,
      "35 coefficients, of x^4, x^3 y, ... to the constant", false },
    { .name = NULL },
};

static const struct field quartic_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct algebraic, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
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
    .size = sizeof(struct algebraic),
    .arguments = quartic_arguments,
    .items = quartic_items,
    .solid = true,
    .bounded = BOUNDS_AS_SHAPE,
    .prepare = quartic_prepare,
    .bounds = algebraic_shape_bounds,
    .intersect = algebraic_shape_intersect,
    .crossings = algebraic_shape_crossings,
    .crosses = algebraic_shape_crosses,
    .first = algebraic_shape_first,
    .normal = algebraic_shape_normal,
    .inside = algebraic_shape_inside,
    .meets = algebraic_shape_meets,
};
