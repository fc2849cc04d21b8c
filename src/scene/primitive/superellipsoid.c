/* superellipsoid { <E, N> }: (|x|^(2/E) + |y|^(2/E))^(E/N) + |z|^(2/N) = 1,
 * from a box with round edges over the sphere <1, 1> to pinched stars. */
#include "scene/primitive.h"

struct superellipsoid {
    double exponents[2]; /* E: around z, N: along z */
    int powers[2];       /* 2/E and 2/N, if they are whole numbers; else 0 */
};

enum { POWER_MOST = 64 };

/* Smaller ones draw the same (measured). */
static const double exponent_least = 1e-3;

static const struct field superellipsoid_arguments[] = {
    { "exponents", FIELD_VECTOR2, offsetof(struct superellipsoid, exponents), 0,
      1e3, "roundness around z and along z: 0.1 a box, 1 a ball", false },
    { .name = NULL },
};

static const char *superellipsoid_prepare(void *shape, struct arena *arena,
                                          const char **warning)
{
    struct superellipsoid *s = shape;
    (void)arena;
    (void)warning;
    for (int i = 0; i < 2; i++) {
        s->exponents[i] = fmax(s->exponents[i], exponent_least);
        double power = 2 / s->exponents[i], near = rint(power);
        bool whole = near <= POWER_MOST && fabs(power - near) < 1e-12 * power;
        s->powers[i] = whole ? (int)near : 0;
    }
    return NULL;
}

/* (a^p + b^p)^(1/p) of positive numbers, and its slopes by a and by b. */
static double power_norm(double a, double b, double p, double slope[2])
{
    double most = fmax(a, b);
    slope[0] = slope[1] = 0;
    if (!(most > 0))
        return 0;
    double u = a == most ? 1 : pow(a / most, p);
    double v = b == most ? 1 : pow(b / most, p);
    double root = pow(u + v, 1 / p), norm = most * root;
    double rest = root / (u + v);
    slope[0] = a > 0 ? rest * u * most / a : p < 1 ? HUGE_VAL : 0;
    slope[1] = b > 0 ? rest * v * most / b : p < 1 ? HUGE_VAL : 0;
    return norm;
}

/* 1 on the surface and growing with the distance from the origin; a norm, and
 * so convex, as long as both exponents are at most 2. */
static double superellipsoid_norm(const struct superellipsoid *s, vec3 p,
                                  vec3 *gradient)
{
    double flat[2], tall[2];
    double ring = power_norm(fabs(p.x), fabs(p.y), 2 / s->exponents[0], flat);
    double norm = power_norm(ring, fabs(p.z), 2 / s->exponents[1], tall);
    *gradient =
        (vec3){ copysign(tall[0] * flat[0], p.x),
                copysign(tall[0] * flat[1], p.y), copysign(tall[1], p.z) };
    return norm;
}

static double power_of(double a, int n)
{
    double result = 1;
    for (; n > 0; n >>= 1, a *= a)
        if (n & 1)
            result *= a;
    return result;
}

/* (|x|^p + |y|^p)^(q/p) + |z|^q - 1 where p is whole and q at least 1: many
 * times quicker than the norm, has the same sign, and is as convex. */
static double superellipsoid_whole(const struct superellipsoid *s, vec3 at,
                                   vec3 *gradient)
{
    int p = s->powers[0], n = s->powers[1];
    double q = 2 / s->exponents[1];
    vec3 a = { fabs(at.x), fabs(at.y), fabs(at.z) };
    double x = power_of(a.x, p - 1), y = power_of(a.y, p - 1);
    double z = n ? power_of(a.z, n - 1) : pow(a.z, q - 1);
    double ring = x * a.x + y * a.y, scale = 1;
    if (p != n)
        scale = ring > 0 ? pow(ring, q / p - 1) : 0;
    *gradient = (vec3){ copysign(q * scale * x, at.x),
                        copysign(q * scale * y, at.y), copysign(q * z, at.z) };
    return scale * ring + z * a.z - 1;
}

/* Below 0 inside, above it outside, and what it grows by. */
static double superellipsoid_value(const struct superellipsoid *s, vec3 p,
                                   vec3 *gradient)
{
    return s->powers[0] > 0 && s->exponents[1] <= 2
               ? superellipsoid_whole(s, p, gradient)
               : superellipsoid_norm(s, p, gradient) - 1;
}

static struct box3 superellipsoid_bounds(const void *shape)
{
    (void)shape;
    return (struct box3){ { -1, -1, -1 }, { 1, 1, 1 } };
}

/* The part of the line in the box around the shape. */
static bool line_in_box(const struct ray *ray, double *low, double *high)
{
    *low = -HUGE_VAL;
    *high = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double o = vec3_component(ray->origin, i);
        double d = vec3_component(ray->direction, i);
        if (d == 0 && fabs(o) > 1)
            return false;
        if (d == 0)
            continue;
        double a = (-1 - o) / d, b = (1 - o) / d;
        *low = fmax(*low, fmin(a, b));
        *high = fmin(*high, fmax(a, b));
    }
    return *low < *high;
}

/* From outside towards the shape: as the norm is convex, Newton's steps come
 * to the surface without passing it, or to where it grows again: a miss. When a
 * step shrank k-fold, what is left after it is k^2 times smaller. */
static bool convex_root(const struct superellipsoid *s, const struct ray *ray,
                        double from, double sign, double *root)
{
    double t = from, last = 0;
    for (int round = 0; round < 100; round++) {
        vec3 gradient;
        double value = superellipsoid_value(s, ray_point(ray, t), &gradient);
        double slope = sign * vec3_dot(gradient, ray->direction);
        *root = t;
        if (value <= 1e-15)
            return true;
        if (!(slope < 0))
            return false;
        double step = -value / slope, shrunk = step / last;
        t += sign * step;
        *root = t;
        if (step * (shrunk < 0.01 ? shrunk * shrunk : 1) <= 1e-16 * fabs(t))
            return true;
        last = step;
    }
    return true;
}

static bool superellipsoid_holds(const struct superellipsoid *s,
                                 const struct ray *ray, double t)
{
    vec3 unused;
    return superellipsoid_value(s, ray_point(ray, t), &unused) < 0;
}

/* ---- pinched ones: an exponent above 2, so that a power is below 1 ---- */

/* (|x|^p + |y|^p)^(q/p) + |z|^q - 1. */
static double pinched_value(const struct superellipsoid *s, vec3 at)
{
    double p = 2 / s->exponents[0], q = 2 / s->exponents[1];
    double ring = pow(fabs(at.x), p) + pow(fabs(at.y), p);
    return (p == q ? ring : pow(ring, q / p)) + pow(fabs(at.z), q) - 1;
}

/* x^power at least, x from 0 to 1: by as many square roots, or squares, as make
 * a power that is no smaller. */
static double power_least(double x, double power)
{
    for (; power <= 0.5; power *= 2)
        x = sqrt(x);
    for (; power > 1; power /= 2)
        x *= x;
    return x;
}

/* And at most: a power that is no larger. */
static double power_most(double x, double power)
{
    for (; power < 1; power *= 2)
        x = sqrt(x);
    for (; power >= 2; power /= 2)
        x *= x;
    return x;
}

/* As pinched_value below 0; most places need no power to be computed. */
static bool pinched_holds(const struct superellipsoid *s, vec3 at)
{
    double p = 2 / s->exponents[0], q = 2 / s->exponents[1];
    double x = fabs(at.x), y = fabs(at.y), z = fabs(at.z);
    if (!(x < 1) || !(y < 1) || !(z < 1))
        return false;
    double ring = power_least(x, p) + power_least(y, p);
    if (ring >= 1 || power_least(ring, q / p) + power_least(z, q) >= 1)
        return false;
    ring = power_most(x, p) + power_most(y, p);
    return (ring < 1 && power_most(ring, q / p) + power_most(z, q) < 1) ||
           pinched_value(s, at) < 0;
}

/* Where |normal * p| is less than 1. */
static bool line_in_slab(const struct ray *ray, vec3 normal, double *low,
                         double *high)
{
    double o = vec3_dot(ray->origin, normal);
    double d = vec3_dot(ray->direction, normal);
    if (d == 0)
        return fabs(o) < 1;
    double a = (-1 - o) / d, b = (1 - o) / d;
    *low = fmax(*low, fmin(a, b));
    *high = fmin(*high, fmax(a, b));
    return *low < *high;
}

/* The part of the line in the pyramids around the shape: a number from 0 to 1
 * to a power below 1 is no less than itself. */
static bool line_in_pyramids(const struct superellipsoid *s,
                             const struct ray *ray, double *low, double *high)
{
    static const vec3 slabs[3][4] = {
        { { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } },
        { { 1, 1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { 1, -1, 0 } },
        { { 1, 0, 1 }, { 1, 0, -1 }, { 0, 1, 1 }, { 0, 1, -1 } },
    };
    int which = s->exponents[1] <= 2 ? 1 : s->exponents[0] <= 2 ? 2 : 0;
    for (int i = 0; i < 4; i++)
        if (!line_in_slab(ray, slabs[which][i], low, high))
            return false;
    return true;
}

enum { PIECES = 32 };

/* Where they are looked at, increasing: in even steps, and where the line
 * passes the planes of two axes, for there are their thin edges. */
static int pinched_places(const struct ray *ray, double low, double high,
                          int pieces, double places[PIECES + 4])
{
    int count = 0;
    for (int i = 0; i <= pieces; i++)
        places[count++] = low + (high - low) * i / pieces;
    for (int i = 0; i < 3; i++) {
        double t =
            -vec3_component(ray->origin, i) / vec3_component(ray->direction, i);
        int at = count;
        if (!(t > low && t < high))
            continue;
        for (; places[at - 1] > t; at--)
            places[at] = places[at - 1];
        places[at] = t;
        count++;
    }
    return count;
}

/* Between a and b, of which one is in and one is out: by the false position,
 * whose end that stays counts half (Illinois), and by halves now and then. */
static double pinched_root(const struct superellipsoid *s,
                           const struct ray *ray, double a, double b)
{
    double at_a = pinched_value(s, ray_point(ray, a));
    double at_b = pinched_value(s, ray_point(ray, b));
    double t = a;
    int stays = 0;
    for (int round = 0; round < 100; round++) {
        t = (a * at_b - b * at_a) / (at_b - at_a);
        if (round % 4 == 3 || !(t > a && t < b))
            t = 0.5 * (a + b);
        double value = pinched_value(s, ray_point(ray, t));
        if (fabs(value) <= 1e-15 || b - a <= 1e-15 * fmax(1, fabs(b)))
            break;
        if ((value < 0) == (at_a < 0)) {
            a = t;
            at_a = value;
            at_b = stays > 0 ? at_b / 2 : at_b;
            stays = 1;
        } else {
            b = t;
            at_b = value;
            at_a = stays < 0 ? at_a / 2 : at_a;
            stays = -1;
        }
    }
    return t;
}

/* On its way along the line. */
struct pinched_walk {
    double places[PIECES + 4];
    int count, at; /* of places; how many are behind */
    bool in;       /* whether the last of these is in */
};

/* False: the line stays away from the shape. */
static bool pinched_walk_start(struct pinched_walk *walk,
                               const struct superellipsoid *s,
                               const struct ray *ray, double low, double high)
{
    double whole = high - low;
    if (!line_in_pyramids(s, ray, &low, &high))
        return false;
    int pieces = (int)ceil(PIECES * (high - low) / whole);
    walk->count = pinched_places(ray, low, high, pieces, walk->places);
    walk->at = 1;
    walk->in = false;
    return true;
}

/* To the next two places of which one is in and one is out: between them, ends
 * of the part [a, b], the line meets the surface. */
static bool pinched_walk_on(struct pinched_walk *walk,
                            const struct superellipsoid *s,
                            const struct ray *ray, double *a, double *b)
{
    while (walk->at < walk->count) {
        int i = walk->at++;
        bool was = walk->in;
        walk->in = i < walk->count - 1 &&
                   pinched_holds(s, ray_point(ray, walk->places[i]));
        *a = walk->places[i - 1];
        *b = walk->places[i];
        if (walk->in != was)
            return true;
    }
    return false;
}

static void pinched_intersect(const struct superellipsoid *s,
                              const struct ray *ray, double low, double high,
                              struct hits *hits)
{
    struct pinched_walk walk;
    double a, b;
    if (!pinched_walk_start(&walk, s, ray, low, high))
        return;
    while (pinched_walk_on(&walk, s, ray, &a, &b))
        hits_add(hits, pinched_root(s, ray, a, b), 0);
}

/* The first between tmin and tmax; `any`: whether there is one, *t need not be
 * it. */
static bool pinched_first(const struct superellipsoid *s, const struct ray *ray,
                          double tmin, double tmax, bool any, double *t)
{
    struct pinched_walk walk;
    double low, high, a, b;
    if (!line_in_box(ray, &low, &high) || !(low < tmax) || !(high > tmin) ||
        !pinched_walk_start(&walk, s, ray, low, high))
        return false;
    while (pinched_walk_on(&walk, s, ray, &a, &b)) {
        if (b <= tmin)
            continue;
        if (a >= tmax)
            return false;
        if (any && a > tmin && b < tmax)
            return true;
        *t = pinched_root(s, ray, a, b);
        if (*t > tmin && *t < tmax)
            return true;
    }
    return false;
}

static bool superellipsoid_pinched(const struct superellipsoid *s)
{
    return s->exponents[0] > 2 || s->exponents[1] > 2;
}

static void superellipsoid_intersect(const void *shape, const struct ray *ray,
                                     struct hits *hits)
{
    const struct superellipsoid *s = shape;
    double low, high, first, second;
    if (!line_in_box(ray, &low, &high))
        return;
    if (superellipsoid_pinched(s)) {
        pinched_intersect(s, ray, low, high, hits);
        return;
    }
    if (!convex_root(s, ray, low, 1, &first) ||
        !convex_root(s, ray, high, -1, &second) || !(first < second))
        return;
    hits_add(hits, first, 0);
    hits_add(hits, second, 0);
}

/* Of a convex one: into it from where the ray begins, or out of it. */
static bool superellipsoid_first(const void *shape, const struct ray *ray,
                                 double tmin, double tmax, struct hit *hit)
{
    const struct superellipsoid *s = shape;
    double low, high;
    *hit = (struct hit){ 0, 0, 0, 0 };
    if (superellipsoid_pinched(s))
        return pinched_first(s, ray, tmin, tmax, false, &hit->t);
    if (!line_in_box(ray, &low, &high) || !(low < tmax) || !(high > tmin))
        return false;
    bool inside = low <= tmin && superellipsoid_holds(s, ray, tmin);
    bool met = inside ? convex_root(s, ray, high, -1, &hit->t)
                      : convex_root(s, ray, fmax(low, tmin), 1, &hit->t);
    return met && hit->t > tmin && hit->t < tmax;
}

static bool superellipsoid_crosses(const void *shape, const struct ray *ray,
                                   double tmin, double tmax)
{
    struct hit hit;
    if (superellipsoid_pinched(shape))
        return pinched_first(shape, ray, tmin, tmax, true, &hit.t);
    return superellipsoid_first(shape, ray, tmin, tmax, &hit);
}

static vec3 superellipsoid_normal(const void *shape, const vec3 *at,
                                  const struct hit *hit)
{
    const vec3 point = *at;
    vec3 gradient;
    (void)hit;
    superellipsoid_value(shape, point, &gradient);
    double peak =
        fmax(fabs(gradient.x), fmax(fabs(gradient.y), fabs(gradient.z)));
    return peak > 0 && isfinite(peak) ? gradient : point;
}

static bool superellipsoid_inside(const void *shape, vec3 point)
{
    vec3 unused;
    return superellipsoid_value(shape, point, &unused) < 0;
}

const struct primitive superellipsoid_primitive = {
    .name = "superellipsoid",
    .help = "between box, cylinder, ball and star",
    .size = sizeof(struct superellipsoid),
    .arguments = superellipsoid_arguments,
    .solid = true,
    .prepare = superellipsoid_prepare,
    .bounds = superellipsoid_bounds,
    .intersect = superellipsoid_intersect,
    .first = superellipsoid_first,
    .crosses = superellipsoid_crosses,
    .normal = superellipsoid_normal,
    .inside = superellipsoid_inside,
};
