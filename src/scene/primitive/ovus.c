/* ovus { BOTTOM RADIUS, TOP RADIUS }: an egg around the y axis. A ball around
 * the origin, one on its top, and between them an arc that touches both, turned
 * around the axis: the inner part of a torus that meets itself. */
#include "scene/polynomial.h"
#include "scene/primitive.h"

enum { OVUS_BOTTOM, OVUS_TOP, OVUS_SIDE };

struct ovus {
    double bottom, top; /* radii */
    bool sturm;
    double arc;           /* radius of the arc */
    double reach, height; /* of its middle: away from the axis, and up */
    double lower, upper;  /* heights where it touches the balls */
};

static const struct field ovus_arguments[] = {
    { "bottom radius", FIELD_FLOAT, offsetof(struct ovus, bottom), 0, HUGE_VAL,
      "of the ball around the origin", false },
    { "top radius", FIELD_FLOAT, offsetof(struct ovus, top), 0, HUGE_VAL,
      "of the ball whose middle is on top of it", false },
    { .name = NULL },
};

static const struct field ovus_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct ovus, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
    { .name = NULL },
};

/* The arc's radius is twice the larger ball's (measured), and its middle so far
 * from the middles of the balls that it touches them from outside. */
static const char *ovus_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct ovus *o = shape;
    (void)arena;
    (void)warning;
    o->arc = 2 * fmax(o->bottom, o->top);
    double low = o->arc - o->bottom, high = o->arc - o->top;
    if (!(o->bottom > 0)) {
        o->lower = o->upper = -HUGE_VAL;
        return NULL;
    }
    o->height =
        (low * low - high * high + o->bottom * o->bottom) / (2 * o->bottom);
    double square = low * low - o->height * o->height;
    if (!(square > 0)) { /* one ball holds the other */
        o->lower = o->upper = o->top > o->bottom ? -HUGE_VAL : HUGE_VAL;
        return NULL;
    }
    o->reach = sqrt(square);
    o->lower = -o->bottom * o->height / low;
    o->upper = o->bottom + o->top * (o->bottom - o->height) / high;
    return NULL;
}

static struct box3 ovus_bounds(const void *shape)
{
    const struct ovus *o = shape;
    double r = fmax(fmax(o->bottom, o->top), o->arc - o->reach);
    if (!(o->lower < o->upper))
        r = fmax(o->bottom, o->top);
    return (struct box3){ { -r, fmin(-o->bottom, o->bottom - o->top), -r },
                          { r, fmax(o->bottom, o->bottom + o->top), r } };
}

/* What of a ball around a point of the axis is seen: from a height to another.
 */
struct ovus_end {
    double y, radius;
    double low, high;
    int part;
};

static void ovus_ball(const struct ray *ray, struct ovus_end end,
                      struct hits *hits)
{
    double roots[2];
    vec3 w = vec3_sub(ray->origin, vec3_make(0, end.y, 0));
    vec3 d = ray->direction;
    if (quadratic_roots(vec3_dot(d, d), vec3_dot(w, d),
                        vec3_dot(w, w) - end.radius * end.radius, roots) != 2)
        return;
    for (int i = 0; i < 2; i++) {
        double at = ray->origin.y + roots[i] * d.y;
        if (at >= end.low && at < end.high)
            hits_add(hits, roots[i], end.part);
    }
}

/* With q = |p|^2 + reach^2 - arc^2, p from the height of the arc's middle,
 * q^2 = 4 reach^2 (distance from the axis)^2; the inner part is where q < 0. */
static void ovus_side(const struct ovus *o, const struct ray *ray,
                      struct hits *hits)
{
    vec3 w = vec3_sub(ray->origin, vec3_make(0, o->height, 0));
    vec3 d = ray->direction;
    double h2 = o->reach * o->reach, roots[4];
    double q0 = vec3_dot(w, w) + h2 - o->arc * o->arc;
    double q1 = 2 * vec3_dot(w, d), q2 = vec3_dot(d, d);
    double c[5] = {
        q0 * q0 - 4 * h2 * (w.x * w.x + w.z * w.z),
        2 * q0 * q1 - 8 * h2 * (w.x * d.x + w.z * d.z),
        q1 * q1 + 2 * q0 * q2 - 4 * h2 * (d.x * d.x + d.z * d.z),
        2 * q1 * q2,
        q2 * q2,
    };
    double bound = polynomial_bound(c, 4);
    int count = polynomial_roots(c, 4, -bound, bound, roots, 4);
    for (int i = 0; i < count; i++) {
        double t = roots[i], at = ray->origin.y + t * d.y;
        if (q0 + t * (q1 + t * q2) < 0 && at >= o->lower && at < o->upper)
            hits_add(hits, t, OVUS_SIDE);
    }
}

/* From where the ray passes the egg, where numbers are small. */
static void ovus_intersect(const void *shape, const struct ray *ray,
                           struct hits *hits)
{
    const struct ovus *o = shape;
    double dd = vec3_dot(ray->direction, ray->direction);
    if (!(dd > 0))
        return;
    double shift = -vec3_dot(ray->origin, ray->direction) / dd;
    struct ray near = { ray_point(ray, shift), ray->direction };
    int first = hits->count;
    const struct ovus_end bottom = { 0, o->bottom, -HUGE_VAL, o->lower,
                                     OVUS_BOTTOM };
    const struct ovus_end top = { o->bottom, o->top, o->upper, HUGE_VAL,
                                  OVUS_TOP };
    ovus_ball(&near, bottom, hits);
    ovus_ball(&near, top, hits);
    if (o->lower < o->upper)
        ovus_side(o, &near, hits);
    for (int i = first; i < hits->count; i++)
        hits->at[i].t += shift;
}

static vec3 ovus_normal(const void *shape, const vec3 *at,
                        const struct hit *hit)
{
    const vec3 point = *at;
    const struct ovus *o = shape;
    if (hit->part == OVUS_BOTTOM)
        return point;
    if (hit->part == OVUS_TOP)
        return vec3_sub(point, vec3_make(0, o->bottom, 0));
    double radius = sqrt(point.x * point.x + point.z * point.z);
    double share = radius > 0 ? 1 + o->reach / radius : 1;
    return vec3_make(point.x * share, point.y - o->height, point.z * share);
}

static bool ovus_inside(const void *shape, vec3 point)
{
    const struct ovus *o = shape;
    double r2 = point.x * point.x + point.z * point.z, y = point.y;
    if (y < o->lower)
        return r2 + y * y < o->bottom * o->bottom;
    if (y >= o->upper)
        return r2 + (y - o->bottom) * (y - o->bottom) < o->top * o->top;
    double out = sqrt(r2) + o->reach, up = y - o->height;
    return out * out + up * up < o->arc * o->arc;
}

/* Longitude and, seen from half its height, latitude (measured). */
static void ovus_uv(const void *shape, vec3 point, double uv[2])
{
    const struct ovus *o = shape;
    double turn = atan2(point.z, point.x) / (2 * M_PI);
    double low = fmin(-o->bottom, o->bottom - o->top);
    double middle = (low + o->bottom + o->top) / 2;
    double across = hypot(point.x, point.z), up = point.y - middle;
    uv[0] = turn < 0 ? turn + 1 : turn;
    uv[1] = atan2(across, -up) / M_PI;
}

const struct primitive ovus_primitive = {
    .name = "ovus",
    .help = "an egg around the y axis, by the radii of its ends",
    .size = sizeof(struct ovus),
    .arguments = ovus_arguments,
    .items = ovus_items,
    .solid = true,
    .prepare = ovus_prepare,
    .bounds = ovus_bounds,
    .intersect = ovus_intersect,
    .normal = ovus_normal,
    .uv = ovus_uv,
    .inside = ovus_inside,
};
