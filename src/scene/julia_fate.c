/* Julia sets of squares and cubes, quickly: see julia_fate.h. Distances are by
 * J. Hart, D. Sandin and L. Kauffman, "Ray Tracing Deterministic 3-D Fractals"
 * (SIGGRAPH 1989): |z| ln |z| / (2 |z'|) is no more than the distance from the
 * set that stays for ever. That of a certain number of steps reaches farther,
 * by its own potential: ln |z| shrinks to that of its surface. */
#include "scene/julia_fate.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/octet_math.h"
#include "base/quad.h"

/* Of all that stays a ray goes at most so much of the radius at a time: an
 * estimate by derivatives knows nothing of what is farther. */
static const double fate_cap = 0.02;

/* The size that ends an orbit, squared: its logarithm is then the potential. */
static const double fate_far = 1e4;

/* That from which on the logarithm is doubled by each step. */
static const double beyond_far = 1e6;

/* Whose points they are. */
enum julia_kind { JULIA_SQUARES, JULIA_CUBES, JULIA_TWINS };

/* Numbers of four parts; a hypercomplex one is two complex ones that know
 * nothing of each other (julia_orbit.c): first the one, then the other. */
struct numbers {
    quad part[4];
    quad half2[2], size2; /* sizes, squared: of complex ones, and of all */
};

INLINED void numbers_start(const struct julia_fractal *f,
                           const struct julia_points *p, int from,
                           enum julia_kind kind, struct numbers *n)
{
    const quad x = quad_of(&p->x, from), y = quad_of(&p->y, from);
    const quad z = quad_of(&p->z, from);
    const quad w = f->w[0] * x + f->w[1] * y + f->w[2] * z + f->w[3];
    bool twins = kind == JULIA_TWINS;
    n->part[0] = twins ? x - w : x;
    n->part[1] = twins ? y + z : y;
    n->part[2] = twins ? x + w : z;
    n->part[3] = twins ? y - z : w;
}

INLINED void numbers_measure(struct numbers *n, enum julia_kind kind)
{
    const quad *v = n->part;
    n->half2[0] = v[0] * v[0] + v[1] * v[1];
    n->half2[1] = v[2] * v[2] + v[3] * v[3];
    n->size2 = n->half2[0] + n->half2[1];
    if (kind == JULIA_TWINS)
        n->size2 /= 2;
}

/* Those that are measured. */
INLINED void numbers_step(const struct julia_fractal *f, struct numbers *n,
                          enum julia_kind kind)
{
    quad *v = n->part;
    const quad real = v[0] * v[0], rest = n->size2 - real;
    const quad factor = kind == JULIA_CUBES ? 3 * real - rest : 2 * v[0];
    if (kind == JULIA_TWINS) {
        v[1] = factor * v[1] + (f->c[1] + f->c[2]);
        v[0] = 2 * real - n->half2[0] + (f->c[0] - f->c[3]);
        v[3] = 2 * v[2] * v[3] + (f->c[1] - f->c[2]);
        v[2] = 2 * v[2] * v[2] - n->half2[1] + (f->c[0] + f->c[3]);
        return;
    }
    v[0] = (kind == JULIA_CUBES ? v[0] * (real - 3 * rest) : real - rest) +
           f->c[0];
    for (int k = 1; k < 4; k++)
        v[k] = factor * v[k] + f->c[k];
}

/* By how much the step lengthens derivatives, squared: of either complex
 * number. */
INLINED quad numbers_growth(const struct numbers *n, enum julia_kind kind,
                            int half)
{
    return kind == JULIA_TWINS   ? 4 * n->half2[half]
           : kind == JULIA_CUBES ? 9 * n->size2 * n->size2
                                 : 4 * n->size2;
}

/* What has become of points: of each the size and the length of its derivative
 * when all was known, both squared. */
struct flights {
    octet size2, half2[2], growth2[2]; /* halves of twins only */
    octet_bits steps;
    octet_bits gone; /* out of the radius that a step allows, once */
    octet_bits open; /* not all is known */
};

/* On their way: of those that are open. */
struct flying {
    quad growth2[2];
    quad size2, half2[2];
    quad_bits steps, gone, open;
};

/* All is known of what is far away, of what the last step has not left, and of
 * what has left and went on for long enough. Returns whether that leaves any
 * after that many steps. */
INLINED bool flying_judge(const struct julia_fractal *f, struct flying *fl,
                          const struct numbers *n, int steps)
{
    const int last = f->iterations - 1;
    const double limit = f->limits[steps];
    quad_bits ends = n->size2 > fate_far;
    fl->gone |= fl->open & (n->size2 > limit * limit);
    if (steps >= last)
        ends |= ~fl->gone;
    fl->open &= ~ends;
    return steps < last + JULIA_MORE && quad_any(fl->open);
}

INLINED void flights_store(const struct flying *now, int from,
                           enum julia_kind kind, struct flights *fl)
{
    quad_into(&fl->size2, from, now->size2);
    quad_into(&fl->growth2[0], from, now->growth2[0]);
    if (kind == JULIA_TWINS) {
        quad_into(&fl->growth2[1], from, now->growth2[1]);
        quad_into(&fl->half2[0], from, now->half2[0]);
        quad_into(&fl->half2[1], from, now->half2[1]);
    }
    quad_bits_into(&fl->steps, from, now->steps);
    quad_bits_into(&fl->gone, from, now->gone);
}

/* Those of four that are open. */
INLINED void flights_part(const struct julia_fractal *f,
                          const struct julia_points *p, int from,
                          enum julia_kind kind, struct flights *fl)
{
    const int halves = kind == JULIA_TWINS ? 2 : 1;
    const quad one = { 1, 1, 1, 1 };
    struct flying now = { .growth2 = { one, one } };
    struct numbers n;
    now.open = quad_bits_of(&fl->open, from);
    if (!quad_any(now.open))
        return;
    numbers_start(f, p, from, kind, &n);
    for (int i = 0;; i++) {
        numbers_measure(&n, kind);
        const quad_bits open = now.open;
        now.size2 = quad_choose(open, n.size2, now.size2);
        for (int k = 0; k < halves && kind == JULIA_TWINS; k++)
            now.half2[k] = quad_choose(open, n.half2[k], now.half2[k]);
        if (!flying_judge(f, &now, &n, i))
            break;
        now.steps -= now.open;
        for (int k = 0; k < halves; k++)
            now.growth2[k] *=
                quad_choose(now.open, numbers_growth(&n, kind, k), one);
        numbers_step(f, &n, kind);
    }
    flights_store(&now, from, kind, fl);
}

INLINED void flights_follow(const struct julia_fractal *f,
                            const struct julia_points *p, enum julia_kind kind,
                            struct flights *fl)
{
    for (int from = 0; from < OCTET; from += QUAD)
        flights_part(f, p, from, kind, fl);
}

/* The number of steps that are left when they are far, and their size then,
 * squared: of those where `open` is set. */
struct leaving {
    const octet_bits *open;
    octet size2;
    octet_bits left;
};

INLINED void numbers_leave(const struct julia_fractal *f,
                           const struct julia_points *p, int from,
                           enum julia_kind kind, struct leaving *leaving)
{
    quad_bits near = quad_bits_of(leaving->open, from), left = { 0 };
    quad size2 = { 0 };
    struct numbers n;
    if (!quad_any(near))
        return;
    numbers_start(f, p, from, kind, &n);
    left = left + f->iterations;
    for (int i = 1;; i++) {
        numbers_measure(&n, kind);
        size2 = quad_choose(near, n.size2, size2);
        left += near;
        near &= n.size2 < beyond_far;
        if (i >= f->iterations || !quad_any(near))
            break;
        numbers_step(f, &n, kind);
    }
    quad_into(&leaving->size2, from, size2);
    quad_bits_into(&leaving->left, from, left);
}

/* Of each kind what is worked out eight at a time. */
struct kind {
    void (*flights)(const struct julia_fractal *f, const struct julia_points *p,
                    struct flights *fl);
    void (*leave)(const struct julia_fractal *f, const struct julia_points *p,
                  struct leaving *leaving);
};

#define KIND(name, kind)                                                       \
    CLONES static void name##_flights(const struct julia_fractal *f,           \
                                      const struct julia_points *p,            \
                                      struct flights *fl)                      \
    {                                                                          \
        flights_follow(f, p, kind, fl);                                        \
    }                                                                          \
    CLONES static void name##_leave(const struct julia_fractal *f,             \
                                    const struct julia_points *p,              \
                                    struct leaving *leaving)                   \
    {                                                                          \
        for (int from = 0; from < OCTET; from += QUAD)                         \
            numbers_leave(f, p, from, kind, leaving);                          \
    }

KIND(squares, JULIA_SQUARES)
KIND(cubes, JULIA_CUBES)
KIND(twins, JULIA_TWINS)

static const struct kind *kind_of(const struct julia_fractal *f)
{
    static const struct kind squares = { squares_flights, squares_leave };
    static const struct kind cubes = { cubes_flights, cubes_leave };
    static const struct kind twins = { twins_flights, twins_leave };
    return f->algebra != JULIA_QUATERNION ? &twins
           : f->cube                      ? &cubes
                                          : &squares;
}

/* The logarithm that the surface's size has after as many steps. Put together
 * by name: numbers that were just stored one by one are read as a vector late.
 */
INLINED octet flights_potential(const struct julia_fractal *f,
                                const struct flights *fl)
{
    const double *p = f->potentials;
    const octet_bits at = fl->steps;
    return (octet){ p[at[0]], p[at[1]], p[at[2]], p[at[3]],
                    p[at[4]], p[at[5]], p[at[6]], p[at[7]] };
}

/* How far what is gone is from what stays, by one size and its derivative. */
CLONES static void flights_outside(const struct julia_fractal *f,
                                   const struct flights *fl, const octet *size2,
                                   const octet *growth2, octet *distance)
{
    octet height = *size2, ratio = *size2 / *growth2;
    octet_ln(&height);
    octet_sqrt(&ratio);
    const octet over = 0.5 * height - flights_potential(f, fl);
    *distance =
        octet_choose(octet_less(over * 0, over), 0.5 * over * ratio, over * 0);
}

/* The same of two complex numbers, when that of one is known. */
CLONES static void twins_outside(const octet *other, octet *distance)
{
    const octet_bits less = octet_less(*distance, *other);
    *distance = octet_choose(less, *other, *distance) / sqrt(2);
}

/* How far what stays is from what doesn't, or so near that it may be. */
CLONES static void flights_inside(const struct julia_fractal *f,
                                  const struct flights *fl, octet *distance)
{
    octet size = fl->size2;
    octet growth = octet_choose(octet_less(fl->growth2[0], fl->growth2[1]),
                                fl->growth2[1], fl->growth2[0]);
    octet_sqrt(&size);
    octet_sqrt(&growth);
    const octet room = 0.5 * (f->radius - size) / growth;
    const octet cap = size * 0 + fate_cap * f->radius;
    *distance = octet_choose(octet_less(room, cap), room, cap);
}

/* Where a distance is a number, that of the slice's points; nothing is known
 * where numbers may come back. */
CLONES static void fates_finish(const struct julia_fractal *f,
                                const struct flights *fl, const octet *inside,
                                const octet *outside, struct julia_fates *fates)
{
    const octet all = octet_choose(fl->gone, *outside, *inside) / f->stretch;
    const octet_bits bits = (octet_bits)all,
                     infinite = (octet_bits){ 0 } + ((int64_t)0x7ff << 52);
    const octet_bits known =
        ~(bits >> 63) & (((bits & INT64_MAX) - infinite) >> 63);
    fates->gone = fl->gone;
    fates->distance =
        octet_choose(f->polynomial ? known : known * 0, all, all * 0);
}

void julia_fates_find(const struct julia_fractal *fractal,
                      const struct julia_points *points, const octet_bits *open,
                      struct julia_fates *fates)
{
    struct flights fl;
    octet inside = { 0 }, outside = { 0 }, other;
    memset(&fl, 0, sizeof fl);
    fl.open = *open;
    kind_of(fractal)->flights(fractal, points, &fl);
    if (octet_any(*open & ~fl.gone))
        flights_inside(fractal, &fl, &inside);
    if (octet_any(fl.gone) && fractal->algebra == JULIA_QUATERNION) {
        flights_outside(fractal, &fl, &fl.size2, &fl.growth2[0], &outside);
    } else if (octet_any(fl.gone)) {
        flights_outside(fractal, &fl, &fl.half2[0], &fl.growth2[0], &outside);
        flights_outside(fractal, &fl, &fl.half2[1], &fl.growth2[1], &other);
        twins_outside(&other, &outside);
    }
    fates_finish(fractal, &fl, &inside, &outside, fates);
}

/* What is far has its logarithm doubled at each step that is left. */
CLONES static void beyond_finish(const struct julia_fractal *f,
                                 const octet *size2, const octet_bits *left,
                                 octet *beyond)
{
    const octet_bits most = (octet_bits){ 0 } + 8;
    const octet_bits few = (*left - most) >> 63;
    const octet_bits doubled = (few & *left) | (~few & most);
    const octet most_height = *size2 * 0 + 1e4;
    octet height = *size2;
    octet_ln(&height);
    height *= (octet)((doubled + 1023) << 52);
    *beyond =
        octet_choose(octet_less(height, most_height), height, most_height) -
        2 * log(f->radius);
}

void julia_fates_beyond(const struct julia_fractal *fractal,
                        const struct julia_points *points,
                        const octet_bits *open, octet *beyond)
{
    struct leaving leaving = { .open = open };
    struct julia_fates fates;
    if (fractal->polynomial) {
        kind_of(fractal)->leave(fractal, points, &leaving);
        beyond_finish(fractal, &leaving.size2, &leaving.left, beyond);
        return;
    }
    julia_fates_find(fractal, points, open, &fates);
    for (int k = 0; k < OCTET; k++)
        (*beyond)[k] = fates.gone[k] ? 1 : -1;
}
