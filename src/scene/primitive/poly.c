/* poly { ORDER, < TERMS > }: an algebraic surface of order 2 to 35. */
#include "scene/algebraic.h"

static const struct field poly_arguments[] = {
    { "order", FIELD_INTEGER, offsetof(struct algebraic, order), 2,
      ALGEBRAIC_ORDER_MAX, "the highest power", false },
    { "terms", FIELD_TERMS, offsetof(struct algebraic, terms), 0, 0,
      "(n+1)(n+2)(n+3)/6 coefficients, of x^n, x^(n-1) y, ... to the constant",
      false },
    { .name = NULL },
};

static const struct field poly_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct algebraic, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
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
    .size = sizeof(struct algebraic),
    .arguments = poly_arguments,
    .items = poly_items,
    .solid = true,
    .bounded = BOUNDS_AS_SHAPE,
    .prepare = poly_prepare,
    .bounds = algebraic_shape_bounds,
    .intersect = algebraic_shape_intersect,
    .crossings = algebraic_shape_crossings,
    .crosses = algebraic_shape_crosses,
    .first = algebraic_shape_first,
    .normal = algebraic_shape_normal,
    .inside = algebraic_shape_inside,
    .meets = algebraic_shape_meets,
};
