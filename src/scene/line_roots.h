/* Crossings of a ray with a shape whose equation along the ray is a polynomial.
 * It is in a parameter of its own, that from where the ray passes nearest to
 * the shape's origin, in the shape's units: root = length t - shift. */
#ifndef SCENE_LINE_ROOTS_H
#define SCENE_LINE_ROOTS_H

#include "scene/polynomial.h"
#include "scene/ray.h"

/* The ray in that parameter: `near` + root `along`, `along` unit. */
struct line {
    vec3 near, along;
    double length, shift;
};

/* False for a ray without a direction. */
static inline bool line_of(struct line *line, const struct ray *ray)
{
    line->length = vec3_length(ray->direction);
    if (!(line->length > 0))
        return false;
    line->along = vec3_scale(ray->direction, 1 / line->length);
    line->shift = -vec3_dot(ray->origin, line->along);
    line->near = vec3_along(ray->origin, line->along, line->shift);
    return true;
}

/* The ray's t of a root, and the root of a t, which may be infinite. */
static inline double line_t(const struct line *line, double root)
{
    return (root + line->shift) / line->length;
}

static inline double line_root(const struct line *line, double t)
{
    return t * line->length - line->shift;
}

/* Tells roots as crossings: see primitive.crossings. */
struct line_visit {
    const struct line *line;
    double tmin, tmax;
    hit_visit *visit;
    void *context;
};

/* For a root_search. */
static inline bool line_visit_root(void *context, double root)
{
    const struct line_visit *v = context;
    const struct hit hit = { line_t(v->line, root), 0, 0, 0 };
    if (!(hit.t > v->tmin))
        return false;
    return hit.t > v->tmax || v->visit(v->context, &hit);
}

#endif
