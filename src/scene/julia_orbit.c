/* Orbits of quaternions and hypercomplex numbers: see julia_orbit.h. How far
 * apart two points can be after each step is bounded by those steps' own
 * inequalities, |(z + e)^2 - z^2| <= 2 |z| |e| + |e|^2 and the like, so no
 * distance is guessed.
 *
 * A hypercomplex number x + y i + z j + w k, where k^2 = 1, is two complex
 * numbers, (x - w) + (y + z) i and (x + w) + (y - z) i, that know nothing of
 * each other: functions are applied to both. */
#include "scene/julia_orbit.h"

static double quad_square(struct quad q)
{
    return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

static struct quad quad_add(struct quad a, struct quad b)
{
    return (struct quad){ a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w };
}

static struct quad quad_multiply(struct quad a, struct quad b)
{
    return (struct quad){
        a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w,
        a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
        a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y,
        a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x,
    };
}

static struct quad quad_conjugate(struct quad a)
{
    return (struct quad){ a.x, -a.y, -a.z, -a.w };
}

static struct quad slice_point(const struct julia_fractal *f, vec3 p)
{
    return (struct quad){
        p.x, p.y, p.z, f->w[0] * p.x + f->w[1] * p.y + f->w[2] * p.z + f->w[3]
    };
}

/* ---- hypercomplex numbers ---- */

struct julia_halves {
    double complex a, b;
};

static struct julia_halves quad_halves(struct quad q)
{
    return (struct julia_halves){ CMPLX(q.x - q.w, q.y + q.z),
                                  CMPLX(q.x + q.w, q.y - q.z) };
}

static struct quad halves_quad(struct julia_halves h)
{
    return (struct quad){ (creal(h.a) + creal(h.b)) / 2,
                          (cimag(h.a) + cimag(h.b)) / 2,
                          (cimag(h.a) - cimag(h.b)) / 2,
                          (creal(h.b) - creal(h.a)) / 2 };
}

static double complex julia_power(const struct julia_fractal *f)
{
    return CMPLX(f->power[0], f->power[1]);
}

/* ---- steps ---- */

static struct quad hypercomplex_step(const struct julia_fractal *f,
                                     struct quad q)
{
    struct julia_halves h = quad_halves(q);
    double complex power = julia_power(f);
    return halves_quad((struct julia_halves){ f->function->value(h.a, power),
                                              f->function->value(h.b, power) });
}

static inline struct quad square_step(struct quad q)
{
    double twice = 2 * q.x;
    return (struct quad){ q.x * q.x - (q.y * q.y + q.z * q.z + q.w * q.w),
                          twice * q.y, twice * q.z, twice * q.w };
}

static inline struct quad cube_step(struct quad q)
{
    double imaginary = q.y * q.y + q.z * q.z + q.w * q.w;
    double real = q.x * q.x, factor = 3 * real - imaginary;
    return (struct quad){ q.x * (real - 3 * imaginary), factor * q.y,
                          factor * q.z, factor * q.w };
}

static inline struct quad julia_step(const struct julia_fractal *f,
                                     struct quad q)
{
    const struct quad c = { f->c[0], f->c[1], f->c[2], f->c[3] };
    if (f->algebra != JULIA_QUATERNION)
        return quad_add(hypercomplex_step(f, q), c);
    return quad_add(f->cube ? cube_step(q) : square_step(q), c);
}

/* Not a number, as of 0 / 0, is gone. */
static bool orbit_push(const struct julia_fractal *f, struct julia_orbit *orbit,
                       int i, struct quad q)
{
    orbit->at[i] = q;
    orbit->size[i] = sqrt(quad_square(q));
    orbit->count = i;
    return !(orbit->size[i] <= f->limits[i]);
}

void julia_orbit_follow(const struct julia_fractal *fractal, vec3 point,
                        struct julia_orbit *orbit)
{
    struct quad q = slice_point(fractal, point);
    int last = fractal->iterations - 1, i = 0;
    orbit->gone = orbit_push(fractal, orbit, i, q);
    while (!orbit->gone && i < last) {
        q = julia_step(fractal, q);
        orbit->gone = orbit_push(fractal, orbit, ++i, q);
    }
    orbit->away = i;
    if (!orbit->gone || fractal->limits[last + 1] == HUGE_VAL)
        return;
    for (int more = 0; more < JULIA_MORE && isfinite(orbit->size[i]); more++) {
        q = julia_step(fractal, q);
        orbit_push(fractal, orbit, ++i, q);
    }
}

/* Follows the point until it is gone, or to the last step, of which the number
 * is returned; where it went is put into `at`. */
static int orbit_leave(const struct julia_fractal *f, vec3 point,
                       struct quad at[JULIA_ITERATIONS])
{
    struct quad q = slice_point(f, point);
    int i = 0;
    for (;; i++) {
        double limit = f->limits[i];
        at[i] = q;
        if (i == f->iterations - 1 || !(quad_square(q) <= limit * limit))
            return i;
        q = julia_step(f, q);
    }
}

bool julia_orbit_gone(const struct julia_fractal *fractal, vec3 point)
{
    struct quad at[JULIA_ITERATIONS];
    int last = orbit_leave(fractal, point, at);
    double limit = fractal->limits[last];
    return !(quad_square(at[last]) <= limit * limit);
}

/* ---- bounds ---- */

/* How far apart a point and others get, step by step. */
struct spread {
    double apart[2]; /* of a hypercomplex number's halves; the first alone, of
                      * a quaternion */
    double all;
};

static void spread_start(struct spread *spread, double e)
{
    spread->all = e;
    spread->apart[0] = spread->apart[1] = sqrt(2) * e;
}

/* A number's size is that of its halves by the root of 2; and so is the
 * difference of two. */
static void spread_step(const struct julia_fractal *f, struct quad q,
                        double size, struct spread *spread)
{
    double e = spread->all;
    if (f->algebra == JULIA_QUATERNION) {
        spread->all *= f->cube ? 3 * size * (size + e) + e * e : 2 * size + e;
        return;
    }
    struct julia_halves h = quad_halves(q);
    double complex power = julia_power(f);
    spread->apart[0] = f->function->spread(h.a, spread->apart[0], power);
    spread->apart[1] = f->function->spread(h.b, spread->apart[1], power);
    double a = spread->apart[0], b = spread->apart[1];
    spread->all = sqrt((a * a + b * b) / 2);
}

/* One that is gone need be so after one of its steps; of one that stays, the
 * last step tells, or all where numbers may come back. */
static bool orbit_sure(const struct julia_fractal *f,
                       const struct julia_orbit *orbit, double e)
{
    struct spread spread;
    spread_start(&spread, e);
    for (int i = 0;; i++) {
        if (!isfinite(spread.all))
            return false;
        if (orbit->gone && i >= orbit->away &&
            orbit->size[i] - spread.all > f->limits[i])
            return true;
        if (!orbit->gone && !(orbit->size[i] + spread.all < f->limits[i]))
            return false;
        if (i == orbit->count)
            return !orbit->gone;
        spread_step(f, orbit->at[i], orbit->size[i], &spread);
    }
}

/* By the derivatives alone; what is sure is less. 0 if it is below `useful`. */
static double orbit_guess(const struct julia_fractal *f,
                          const struct julia_orbit *orbit, double useful)
{
    double growth = 1, most = 0, least = f->radius;
    for (int i = 0; i <= orbit->count; i++) {
        double room = (orbit->size[i] - f->limits[i]) / growth;
        if (i >= orbit->away)
            most = fmax(most, room);
        least = fmin(least, -room);
        if (!orbit->gone && least < useful)
            return 0;
        double size = orbit->size[i];
        if (f->algebra == JULIA_QUATERNION) {
            growth *= f->cube ? 3 * size * size : 2 * size;
            continue;
        }
        struct julia_halves h = quad_halves(orbit->at[i]);
        double complex power = julia_power(f);
        growth *= fmax(complex_size(f->function->slope(h.a, power)),
                       complex_size(f->function->slope(h.b, power)));
    }
    return fmin(orbit->gone ? most : least, f->radius);
}

double julia_orbit_reach(const struct julia_fractal *fractal,
                         const struct julia_orbit *orbit, double useful)
{
    enum { TRIES = 8 };
    double least = useful * fractal->stretch;
    double e = 0.8 * orbit_guess(fractal, orbit, least);
    for (int i = 0; i < TRIES && e > 0 && e >= least; i++, e *= 0.6)
        if (orbit_sure(fractal, orbit, e))
            return e / fractal->stretch;
    return 0;
}

/* ---- normals ---- */

/* The slope of |z|^2 after one more step than took it away, followed back to
 * the point. The step z -> z^2 takes dz to z dz + dz z; back it is by
 * conjugates. */
static struct quad quaternion_back(const struct julia_fractal *f, struct quad z,
                                   struct quad slope)
{
    struct quad c = quad_conjugate(z), square = quad_multiply(c, c);
    if (!f->cube)
        return quad_add(quad_multiply(c, slope), quad_multiply(slope, c));
    return quad_add(
        quad_add(quad_multiply(square, slope), quad_multiply(slope, square)),
        quad_multiply(quad_multiply(c, slope), c));
}

static struct quad hypercomplex_back(const struct julia_fractal *f,
                                     struct quad z, struct quad slope)
{
    struct julia_halves h = quad_halves(z), s = quad_halves(slope);
    double complex power = julia_power(f);
    return halves_quad(
        (struct julia_halves){ s.a * conj(f->function->slope(h.a, power)),
                               s.b * conj(f->function->slope(h.b, power)) });
}

/* That of the three numbers that are seen alone, whatever the slice does with
 * the fourth (measured). */
vec3 julia_orbit_slope(const struct julia_fractal *fractal, vec3 point)
{
    struct quad at[JULIA_ITERATIONS];
    int i = orbit_leave(fractal, point, at);
    struct quad slope = julia_step(fractal, at[i]);
    for (; i >= 0; i--)
        slope = fractal->algebra == JULIA_QUATERNION
                    ? quaternion_back(fractal, at[i], slope)
                    : hypercomplex_back(fractal, at[i], slope);
    return vec3_make(slope.x, slope.y, slope.z);
}
