/* julia_fractal: see julia_fractal.h. Rays go by steps in which nothing can
 * change (julia_march.h), or, of functions of hypercomplex numbers, by short
 * ones (julia_steps.h). */
#include "scene/julia_fractal.h"

#include <string.h>

#include "scene/crossings.h"
#include "scene/julia_glimpse.h"
#include "scene/julia_march.h"
#include "scene/julia_orbit.h"
#include "scene/julia_steps.h"

static const double julia_coarse = 0.02; /* of quaternions that may come back */

static const char *const algebras[] = { "quaternion", "hypercomplex", NULL };

static const struct field julia_arguments[] = {
    { "c", FIELD_VECTOR5, offsetof(struct julia_fractal, c), 0, 0,
      "what is added at each step" },
    { "algebra", FIELD_CHOICE, offsetof(struct julia_fractal, algebra), 0, 0,
      "of what numbers", false, algebras },
    { "cube", FIELD_BOOL, offsetof(struct julia_fractal, cube), 0, 0,
      "instead of the square" },
    { "power", FIELD_VECTOR2, offsetof(struct julia_fractal, power), 0, 0,
      "of pwr" },
    { "slice", FIELD_VECTOR5, offsetof(struct julia_fractal, slice), 0, 0,
      "where the fourth dimension is cut" },
    { NULL },
};

static const struct field julia_items[] = {
    { "max_iteration", FIELD_INTEGER,
      offsetof(struct julia_fractal, iterations), 1, JULIA_ITERATIONS,
      "steps, 20" },
    { "precision", FIELD_FLOAT, offsetof(struct julia_fractal, precision), 0, 0,
      "the shortest step of a ray is 1 / precision, 20" },
    { NULL },
};

void julia_fractal_init(struct julia_fractal *fractal)
{
    fractal->c[0] = 1;
    fractal->function = julia_function_at(0);
    fractal->iterations = 20;
    fractal->precision = 20;
    fractal->slice[3] = 1;
}

/* What stays has |z z + c| <= limit, so that |z z| <= limit + |c| one step
 * before; |z z| is |z|^2 of a quaternion, and of a hypercomplex number between
 * |z|^2 and the root of 2 times that. Nothing is known of other functions, nor
 * where what was larger may come back. */
static void julia_limit(struct julia_fractal *f, double c, struct arena *arena)
{
    bool hypercomplex = f->algebra == JULIA_HYPERCOMPLEX;
    bool cube = f->cube && !hypercomplex;
    int last = f->iterations - 1;
    f->limits = ARENA_ARRAY(arena, double, last + 1 + JULIA_MORE);
    f->limits[last] = f->radius;
    for (int i = last; i > 0; i--) {
        double most = f->limits[i] + c;
        f->limits[i - 1] = fmin(f->radius, !f->polynomial ? f->radius
                                           : cube         ? cbrt(most)
                                                          : sqrt(most));
    }
    for (int i = last; i < last + JULIA_MORE; i++) {
        double square = f->limits[i] * f->limits[i];
        f->limits[i + 1] = !f->polynomial ? HUGE_VAL
                           : cube         ? square * f->limits[i] + c
                           : hypercomplex ? sqrt(2) * square + c
                                          : square + c;
    }
}

/* The logarithm of the radius after the last step, were it seen at another: of
 * a quaternion or of a hypercomplex number's half. */
static void julia_potentials(struct julia_fractal *f, struct arena *arena)
{
    int last = f->iterations - 1;
    bool quaternion = f->algebra == JULIA_QUATERNION;
    double height = log(quaternion ? f->radius : sqrt(2) * f->radius);
    f->potentials = ARENA_ARRAY(arena, double, last + 1 + JULIA_MORE);
    for (int i = 0; i <= last + JULIA_MORE; i++)
        f->potentials[i] =
            height *
            (quaternion && f->cube ? pow(3, i - last) : ldexp(1, i - last));
}

/* The radius is measured. What is larger than it, r, is at least r^2 - |c|
 * after a step: no smaller, if |c| is at most r^2 - r. */
static void julia_ends(struct julia_fractal *f, double c)
{
    bool quaternion = f->algebra == JULIA_QUATERNION;
    double most = quaternion ? 2 : 4;
    f->radius = quaternion ? fmin(1 + c, most) : most;
    f->polynomial =
        c <= most * (most - 1) &&
        (quaternion || f->function->value == julia_function_at(0)->value);
}

/* The slice's normal is made a unit, its distance stays (measured). */
static const char *julia_prepare(void *shape, struct arena *arena,
                                 const char **warning)
{
    struct julia_fractal *f = shape;
    bool quaternion = f->algebra == JULIA_QUATERNION;
    double length2 = 0, c2 = 0;
    (void)warning;
    for (int i = 0; i < 4; i++) {
        length2 += f->slice[i] * f->slice[i];
        c2 += f->c[i] * f->c[i];
    }
    if (!(fabs(f->slice[3]) > 1e-9 * sqrt(length2)) || !isfinite(length2))
        return "the fourth number of its slice's normal must not be 0";
    if (!(f->precision > 0))
        return "its precision must be above 0";
    if (!isfinite(c2))
        return "its numbers must be finite";
    double tilt = 1;
    for (int i = 0; i < 3; i++) {
        f->w[i] = -f->slice[i] / f->slice[3];
        tilt += f->w[i] * f->w[i];
    }
    f->w[3] = f->slice[4] * sqrt(length2) / f->slice[3];
    f->stretch = sqrt(tilt);
    julia_ends(f, sqrt(c2));
    f->stepped = !f->polynomial && !quaternion;
    f->least = f->stepped      ? 1 / fmax(f->precision, 1)
               : f->polynomial ? 1 / f->precision
                               : julia_coarse;
    julia_limit(f, sqrt(c2), arena);
    julia_potentials(f, arena);
    return NULL;
}

static struct box3 julia_bounds(const void *shape)
{
    const struct julia_fractal *f = shape;
    vec3 r = { f->limits[0], f->limits[0], f->limits[0] };
    return (struct box3){ vec3_negate(r), r };
}

/* Around the radius, wherever the fractal itself ends (measured). */
static struct box3 julia_told(const void *shape, const affine *place)
{
    double radius = ((const struct julia_fractal *)shape)->radius;
    vec3 r = { radius, radius, radius };
    return affine_box(place, (struct box3){ vec3_negate(r), r });
}

/* ---- rays ---- */

static void julia_crossings(const void *shape, const struct ray *ray,
                            double tmin, double tmax, hit_visit *visit,
                            void *context)
{
    const struct julia_fractal *f = shape;
    struct julia_march march;
    octet at;
    octet_bits met;
    if (f->stepped) {
        const struct julia_walk walk = { ray, tmin, tmax, false };
        julia_steps_visit(f, &walk, visit, context);
        return;
    }
    julia_march_alone(f, ray, tmin, tmax, &march);
    julia_march_start(f, &march);
    while (march.open[0]) {
        julia_march_next(f, &march, false, &at, &met);
        struct hit hit = { .t = at[0] };
        if (met[0] && visit(context, &hit))
            return;
    }
}

static void julia_intersect(const void *shape, const struct ray *ray,
                            struct hits *hits)
{
    crossings_all(julia_crossings, shape, ray, hits);
}

/* Where each that is open first goes in; HUGE_VAL: nowhere. */
static void march_first(const struct julia_fractal *f,
                        struct julia_march *march, bool rough, double *first)
{
    octet at;
    octet_bits met;
    for (int k = 0; k < OCTET; k++)
        first[k] = HUGE_VAL;
    while (octet_any(march->open)) {
        julia_march_next(f, march, rough, &at, &met);
        for (int k = 0; k < OCTET; k++) {
            first[k] = met[k] ? at[k] : first[k];
            march->open[k] &= ~met[k];
        }
    }
}

/* Where the ray first goes in; HUGE_VAL: nowhere. */
static double julia_first_t(const struct julia_fractal *f,
                            const struct ray *ray, double tmin, double tmax,
                            bool rough)
{
    struct julia_march march;
    double first[OCTET];
    if (f->stepped) {
        struct hit hit = { .t = HUGE_VAL };
        struct crossings_nearest nearest = { &hit, false };
        const struct julia_walk walk = { ray, tmin, tmax, rough };
        julia_steps_visit(f, &walk, crossings_take, &nearest);
        return hit.t;
    }
    julia_march_alone(f, ray, tmin, tmax, &march);
    julia_march_start(f, &march);
    march_first(f, &march, rough, first);
    return first[0];
}

static bool julia_first(const void *shape, const struct ray *ray, double tmin,
                        double tmax, struct hit *hit)
{
    *hit = (struct hit){ .t = julia_first_t(shape, ray, tmin, tmax, false) };
    return hit->t < HUGE_VAL;
}

static bool julia_crosses(const void *shape, const struct ray *ray, double tmin,
                          double tmax)
{
    return julia_first_t(shape, ray, tmin, tmax, true) < HUGE_VAL;
}

static bool julia_first_roughly(const void *shape, const struct ray *ray,
                                double tmin, double tmax, double spread,
                                struct hit *hit)
{
    const struct julia_fractal *f = shape;
    const struct julia_cone cone = { ray, tmin, tmax, spread, !hit };
    const double t = f->stepped ? julia_first_t(f, ray, tmin, tmax, !hit)
                                : julia_glimpse(f, &cone);
    if (hit)
        *hit = (struct hit){ .t = t };
    return t < HUGE_VAL;
}

/* Rays side by side, from lane `from` on, set out. */
static void march_lanes(const struct julia_fractal *f, const struct rays *rays,
                        const struct rays_span *span, int from,
                        struct julia_march *march)
{
    memset(march, 0, sizeof *march);
    for (int k = 0; k < OCTET; k++) {
        const struct ray ray = rays_at(rays, from + k);
        double near = span->near[from + k], far = span->far[from + k];
        julia_march_put(march, k, &ray, near, far);
        march->open[k] = near < far ? -1 : 0;
    }
    julia_march_enter(f, march);
    julia_march_start(f, march);
}

static void julia_first_lanes(const struct julia_fractal *f,
                              const struct rays *rays,
                              const struct rays_span *span, int from,
                              bool rough, double *first)
{
    struct julia_march march;
    if (!f->stepped) {
        march_lanes(f, rays, span, from, &march);
        march_first(f, &march, rough, first);
        return;
    }
    for (int k = 0; k < OCTET; k++) {
        const struct ray ray = rays_at(rays, from + k);
        double near = span->near[from + k], far = span->far[from + k];
        first[k] =
            near < far ? julia_first_t(f, &ray, near, far, rough) : HUGE_VAL;
    }
}

/* Every crossing. */
static void march_all(const struct julia_fractal *f, struct julia_march *march,
                      int from, rays_visit *visit, void *context)
{
    LANE_LINES double t[RAY_LANES];
    octet at;
    octet_bits met;
    while (octet_any(march->open)) {
        unsigned bits = 0, over;
        julia_march_next(f, march, false, &at, &met);
        for (int k = 0; k < OCTET; k++) {
            t[from + k] = at[k];
            bits |= (unsigned)(met[k] != 0) << (from + k);
        }
        over = bits ? visit(context, bits, t) : 0;
        for (int k = 0; k < OCTET; k++)
            march->open[k] = over >> (from + k) & 1 ? 0 : march->open[k];
    }
}

/* One ray of several. */
struct lane_visit {
    rays_visit *visit;
    void *context;
    int lane;
};

static bool visit_lane(void *context, const struct hit *hit)
{
    const struct lane_visit *one = context;
    LANE_LINES double t[RAY_LANES];
    t[one->lane] = hit->t;
    return one->visit(one->context, 1u << one->lane, t) >> one->lane & 1;
}

static void julia_crossings_many(const void *shape, struct lane_run run,
                                 const struct rays *rays,
                                 const struct rays_span *span,
                                 rays_visit *visit, void *context)
{
    const struct julia_fractal *f = shape;
    struct julia_march march;
    for (int from = run.first; !f->stepped && from < run.end; from += OCTET) {
        march_lanes(f, rays, span, from, &march);
        march_all(f, &march, from, visit, context);
    }
    for (int i = run.first; f->stepped && i < run.end; i++) {
        const struct ray ray = rays_at(rays, i);
        struct lane_visit one = { visit, context, i };
        if (span->near[i] < span->far[i])
            julia_crossings(f, &ray, span->near[i], span->far[i], visit_lane,
                            &one);
    }
}

_Static_assert((int)OCTET == (int)LANE_STEP, "an octet is a step of lanes");

static void julia_first_many(const void *shape, struct lane_run run,
                             const struct rays *rays,
                             const struct rays_span *span, struct rays_met *met)
{
    for (int from = run.first; from < run.end; from += OCTET)
        julia_first_lanes(shape, rays, span, from, false, met->t + from);
    memset(met->part, 0, sizeof met->part);
}

static void julia_crosses_many(const void *shape, struct lane_run run,
                               const struct rays *rays,
                               const struct rays_span *span, lane_flag *met)
{
    double first[RAY_LANES];
    for (int from = run.first; from < run.end; from += OCTET) {
        julia_first_lanes(shape, rays, span, from, true, first + from);
        for (int i = from; i < from + OCTET; i++)
            met[i] = first[i] < HUGE_VAL ? -1 : 0;
    }
}

static vec3 julia_normal(const void *shape, const vec3 *at,
                         const struct hit *hit)
{
    const vec3 point = *at;
    vec3 slope = julia_orbit_slope(shape, point);
    double size = fmax(fmax(fabs(slope.x), fabs(slope.y)), fabs(slope.z));
    (void)hit;
    return size > 0 && isfinite(size) ? vec3_scale(slope, 1 / size)
                                      : vec3_make(0, 1, 0);
}

static bool julia_inside(const void *shape, vec3 point)
{
    return !julia_orbit_gone(shape, point);
}

static unsigned julia_meets(const void *shape, const struct cell *cell)
{
    struct julia_orbit orbit;
    if (!cell_meets_box(cell, julia_bounds(shape)))
        return 0;
    julia_orbit_follow(shape, cell->centre, &orbit);
    return julia_orbit_reach(shape, &orbit, cell->radius) > cell->radius
               ? 0
               : CELL_SURFACE | CELL_BORDER;
}

const struct primitive julia_fractal_primitive = {
    .name = "julia_fractal",
    .help = "a slice of a Julia set of four dimensions",
    .size = sizeof(struct julia_fractal),
    .arguments = julia_arguments,
    .items = julia_items,
    .solid = true,
    .bounded = BOUNDS_IGNORED,
    .prepare = julia_prepare,
    .bounds = julia_bounds,
    .told = julia_told,
    .intersect = julia_intersect,
    .crossings = julia_crossings,
    .crosses = julia_crosses,
    .first = julia_first,
    .first_roughly = julia_first_roughly,
    .crosses_many = julia_crosses_many,
    .first_many = julia_first_many,
    .crossings_many = julia_crossings_many,
    .lane_by_lane = true,
    .normal = julia_normal,
    .inside = julia_inside,
    .meets = julia_meets,
};
