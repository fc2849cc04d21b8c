/* superellipsoid { <E, N> }: (|x|^(2/E) + |y|^(2/E))^(E/N) + |z|^(2/N) = 1,
 * from a box with round edges over the sphere <1, 1> to pinched stars. */
#include "scene/primitive.h"

struct superellipsoid {
    double exponents[2]; /* E: around z, N: along z */
    int powers[2];       /* 2/E and 2/N, if they are whole numbers; else 0 */
};

enum { POWER_MOST = 64 };

static const struct field superellipsoid_arguments[] = {
    { "exponents", FIELD_VECTOR2, offsetof(struct superellipsoid, exponents),
      1e-3, 1e3, "roundness around z and along z: 0.1 a box, 1 a ball", false },
    { .name = NULL },
};

static const char *superellipsoid_prepare(void *shape, struct arena *arena,
                                          const char **warning)
{
    struct superellipsoid *s = shape;
    (void)arena;
    (void)warning;
    for (int i = 0; i < 2; i++) {
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

enum { PIECES = 32 };

/* Where pinched ones are looked at, increasing: in even steps, and where the
 * line passes the planes of two axes, for there are their thin edges. */
static int pinched_places(const struct ray *ray, double low, double high,
                          double places[PIECES + 4])
{
    int count = 0;
    for (int i = 0; i <= PIECES; i++)
        places[count++] = low + (high - low) * i / PIECES;
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

/* Between places of which one is in and one is out the line meets it. */
static void pinched_intersect(const struct superellipsoid *s,
                              const struct ray *ray, double low, double high,
                              struct hits *hits)
{
    double places[PIECES + 4];
    int count = pinched_places(ray, low, high, places);
    bool was = false;
    for (int i = 1; i < count; i++) {
        bool in = i < count - 1 && superellipsoid_holds(s, ray, places[i]);
        double a = places[i - 1], b = places[i];
        if (in == was)
            continue;
        for (int round = 0; round < 50; round++) {
            double middle = 0.5 * (a + b);
            if (superellipsoid_holds(s, ray, middle) == was)
                a = middle;
            else
                b = middle;
        }
        hits_add(hits, 0.5 * (a + b), 0);
        was = in;
    }
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
    if (superellipsoid_pinched(s)) {
        struct hits hits = { .count = 0 };
        superellipsoid_intersect(shape, ray, &hits);
        return hits_first(&hits, tmin, tmax, hit);
    }
    if (!line_in_box(ray, &low, &high) || !(low < tmax) || !(high > tmin))
        return false;
    *hit = (struct hit){ 0, 0, 0, 0 };
    bool inside = low <= tmin && superellipsoid_holds(s, ray, tmin);
    bool met = inside ? convex_root(s, ray, high, -1, &hit->t)
                      : convex_root(s, ray, fmax(low, tmin), 1, &hit->t);
    return met && hit->t > tmin && hit->t < tmax;
}

static bool superellipsoid_crosses(const void *shape, const struct ray *ray,
                                   double tmin, double tmax)
{
    struct hit hit;
    return superellipsoid_first(shape, ray, tmin, tmax, &hit);
}

static vec3 superellipsoid_normal(const void *shape, vec3 point,
                                  const struct hit *hit)
{
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
