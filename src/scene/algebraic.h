/* Algebraic surfaces F(x,y,z) = 0 of any order: what cubic, quartic and poly
 * have in common. Inside is where F is negative.
 *
 * Terms are in POV-Ray's order: powers of x falling, then of y, then of z:
 * x^3, x^2y, x^2z, x^2, xy^2, xyz, xy, xz^2, xz, x, y^3, ... , 1. */
#ifndef SCENE_ALGEBRAIC_H
#define SCENE_ALGEBRAIC_H

#include "scene/primitive.h"

enum { ALGEBRAIC_ORDER_MAX = 35 };

struct algebraic {
    int order; /* 1 to ALGEBRAIC_ORDER_MAX */
    struct terms terms;
    bool sturm; /* accepted: the roots are exact anyway */
};

/* (n+1)(n+2)(n+3)/6 */
size_t algebraic_terms(int order);

/* NULL, or what is wrong with the number of terms; the text is in `arena`. */
const char *algebraic_check(const struct algebraic *surface,
                            struct arena *arena);

vec3 algebraic_normal(const struct algebraic *surface, vec3 point);
bool algebraic_inside(const struct algebraic *surface, vec3 point);

/* For shapes made of a struct algebraic. */
struct box3 algebraic_shape_bounds(const void *shape);
void algebraic_shape_intersect(const void *shape, const struct ray *ray,
                               struct hits *hits);
void algebraic_shape_crossings(const void *shape, const struct ray *ray,
                               double tmin, double tmax, hit_visit *visit,
                               void *context);
bool algebraic_shape_crosses(const void *shape, const struct ray *ray,
                             double tmin, double tmax);
bool algebraic_shape_first(const void *shape, const struct ray *ray,
                           double tmin, double tmax, struct hit *hit);
void algebraic_shape_first_many(const void *shape, struct lane_run run,
                                const struct rays *rays,
                                const struct rays_span *span,
                                struct rays_met *met);
void algebraic_shape_crosses_many(const void *shape, struct lane_run run,
                                  const struct rays *rays,
                                  const struct rays_span *span, lane_flag *met);
vec3 algebraic_shape_normal(const void *shape, const vec3 *at,
                            const struct hit *hit);
bool algebraic_shape_inside(const void *shape, vec3 point);
unsigned algebraic_shape_meets(const void *shape, const struct cell *cell);

extern const struct field algebraic_items[];

/* What the primitives of such shapes have alike; `count_text` says how many
 * terms there are. */
#define ALGEBRAIC_TERMS(count_text)                                            \
    {                                                                          \
        "terms", FIELD_TERMS, offsetof(struct algebraic, terms), 0, 0,         \
            count_text, false                                                  \
    }
#define ALGEBRAIC_SHAPE                                                        \
    .size = sizeof(struct algebraic), .items = algebraic_items, .solid = true, \
    .bounded = BOUNDS_AS_SHAPE, .bounds = algebraic_shape_bounds,              \
    .intersect = algebraic_shape_intersect,                                    \
    .crossings = algebraic_shape_crossings,                                    \
    .crosses = algebraic_shape_crosses, .first = algebraic_shape_first,        \
    .lane_by_lane = true, .first_many = algebraic_shape_first_many,            \
    .crosses_many = algebraic_shape_crosses_many,                              \
    .normal = algebraic_shape_normal, .inside = algebraic_shape_inside,        \
    .meets = algebraic_shape_meets

#endif
