/* julia_fractal: see julia_fractal.h. A ray goes on by steps in which nothing
 * can change (julia_fate.h), but no shorter than a limit; where something
 * has, the place is found by regula falsi. Of functions of hypercomplex numbers
 * all steps are that short (julia_steps.h). */
#include "scene/julia_fractal.h"

#include "scene/bracket.h"
#include "scene/julia_fate.h"
#include "scene/julia_orbit.h"
#include "scene/julia_steps.h"

enum {
    JULIA_ROUNDS = 60, /* for one crossing */
};

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

/* ---- rays ---- */

struct march {
    const struct julia_fractal *fractal;
    const struct ray *ray;
    double speed; /* length of the ray's direction */
    bool rough;   /* between which steps it crosses is near enough */
    struct julia_fate fate;
};

/* Whether the point at t stays; and then how far all do as it does. */
static bool march_look(struct march *m, double t)
{
    julia_fate_find(m->fractal, ray_point(m->ray, t), &m->fate);
    return !m->fate.gone;
}

static double march_step(const struct march *m)
{
    return fmax(m->fate.distance, m->fractal->least) / m->speed;
}

/* Above 0 where the point at t is gone: julia_orbit_beyond, but for what went
 * and came back before the last step. */
static double march_beyond(const struct march *m, double t)
{
    const double little = 1e-3;
    vec3 point = ray_point(m->ray, t);
    double beyond = julia_orbit_beyond(m->fractal, point);
    struct julia_fate fate;
    if (m->fractal->polynomial)
        return beyond;
    julia_fate_find(m->fractal, point, &fate);
    return fate.gone == (beyond > 0) ? beyond : fate.gone ? little : -little;
}

/* So near is near enough, of the ray's t. */
static double march_enough(const struct march *m)
{
    return (m->rough ? m->fractal->least : 1e-7 * m->fractal->radius) /
           m->speed;
}

/* The crossing between a and b. */
static double march_refine(const struct march *m, double a, double b)
{
    struct bracket in = { a, march_beyond(m, a), b, march_beyond(m, b) };
    double enough = march_enough(m), t;
    for (int i = 1; i < JULIA_ROUNDS && in.b - in.a > enough; i++) {
        if (!bracket_next(&in, i, &t))
            break;
        double at_t = march_beyond(m, t);
        bracket_narrow(&in, t, at_t, (at_t <= 0) == (in.at_a <= 0));
    }
    /* The one that stays: its slope is the last's. */
    return in.at_a <= 0 ? in.a : in.b;
}

/* Where the ray is in the ball around it, a little within: where the ball cuts
 * through what stays there is no surface (measured). */
static bool march_start(struct march *m, double *tmin, double *tmax)
{
    vec3 o = m->ray->origin, d = m->ray->direction;
    double dd = vec3_dot(d, d), middle = -vec3_dot(o, d) / dd;
    vec3 nearest = vec3_along(o, d, middle);
    const struct julia_fractal *f = m->fractal;
    double radius = f->limits[0] * (1 - 1e-6);
    double rest = radius * radius - vec3_dot(nearest, nearest);
    if (!(rest > 0))
        return false;
    *tmin = fmax(*tmin, middle - sqrt(rest / dd));
    *tmax = fmin(*tmax, middle + sqrt(rest / dd));
    m->speed = sqrt(dd);
    return *tmin < *tmax;
}

static void march_along(struct march *m, double tmin, double tmax,
                        hit_visit *visit, void *context)
{
    if (!march_start(m, &tmin, &tmax))
        return;
    if (m->fractal->stepped) {
        const struct julia_walk walk = { m->ray, tmin, tmax,
                                         m->fractal->least / m->speed,
                                         march_enough(m) };
        julia_steps_visit(m->fractal, &walk, visit, context);
        return;
    }
    double t = tmin;
    bool stays = march_look(m, t);
    for (int i = 0; i < JULIA_STEPS && t < tmax; i++) {
        double next = fmin(t + march_step(m), tmax);
        bool stayed = stays;
        stays = march_look(m, next);
        if (stays != stayed) {
            double at = m->rough ? (t + next) / 2 : march_refine(m, t, next);
            struct hit hit = { at, 0, 0, 0 };
            if (hit.t > tmin && hit.t < tmax && visit(context, &hit))
                return;
        }
        if (!(next > t))
            return;
        t = next;
    }
}

static void julia_crossings(const void *shape, const struct ray *ray,
                            double tmin, double tmax, hit_visit *visit,
                            void *context)
{
    struct march m = { .fractal = shape, .ray = ray };
    march_along(&m, tmin, tmax, visit, context);
}

static bool take_all(void *context, const struct hit *hit)
{
    struct hits *hits = context;
    hits_add(hits, hit->t, 0);
    return hits->count == HITS_MAX;
}

static void julia_intersect(const void *shape, const struct ray *ray,
                            struct hits *hits)
{
    julia_crossings(shape, ray, -HUGE_VAL, HUGE_VAL, take_all, hits);
}

struct first_crossing {
    struct hit hit;
    bool found;
};

static bool take_first(void *context, const struct hit *hit)
{
    struct first_crossing *first = context;
    first->hit = *hit;
    first->found = true;
    return true;
}

static bool julia_first(const void *shape, const struct ray *ray, double tmin,
                        double tmax, struct hit *hit)
{
    struct first_crossing first = { .found = false };
    julia_crossings(shape, ray, tmin, tmax, take_first, &first);
    *hit = first.hit;
    return first.found;
}

static bool julia_crosses(const void *shape, const struct ray *ray, double tmin,
                          double tmax)
{
    struct march m = { .fractal = shape, .ray = ray, .rough = true };
    struct first_crossing first = { .found = false };
    march_along(&m, tmin, tmax, take_first, &first);
    return first.found;
}

static vec3 julia_normal(const void *shape, vec3 point, const struct hit *hit)
{
    vec3 slope = julia_orbit_slope(shape, point);
    double size = fmax(fmax(fabs(slope.x), fabs(slope.y)), fabs(slope.z));
    (void)hit;
    return size > 0 && isfinite(size) ? vec3_scale(slope, 1 / size)
                                      : vec3_make(0, 1, 0);
}

static bool julia_inside(const void *shape, vec3 point)
{
    const struct julia_fractal *f = shape;
    if (f->stepped)
        return !julia_orbit_gone(f, point);
    struct julia_fate fate;
    julia_fate_find(f, point, &fate);
    return !fate.gone;
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
    .prepare = julia_prepare,
    .bounds = julia_bounds,
    .intersect = julia_intersect,
    .crossings = julia_crossings,
    .crosses = julia_crosses,
    .first = julia_first,
    .normal = julia_normal,
    .inside = julia_inside,
    .meets = julia_meets,
};
