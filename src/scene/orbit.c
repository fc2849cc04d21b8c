/* Orbits, some side by side, and what they are coloured by, as measured: see
 * orbit.h. */
#include "scene/orbit.h"

#include <limits.h>
#include <math.h>

#include "base/clones.h"

/* The ways that exterior and interior share: by the last point. */
static double orbit_end(int way, double x, double y)
{
    switch (way) {
    case 2:
        return x;
    case 3:
        return y;
    case 4:
        return x * x;
    case 5:
        return y * y;
    case 6:
        return sqrt(x * x + y * y);
    default:
        return 1;
    }
}

/* A scene may say any number. */
static int orbit_integer(double number)
{
    return (int)fmax(-1e6, fmin(number, 1e6));
}

/* Left the circle of radius 2 after `steps` that stayed in it. */
static double orbit_exterior(const struct orbit *orbit, int steps, double x,
                             double y)
{
    double factor = orbit->exterior[1];
    int way = orbit_integer(orbit->exterior[0]);
    int period = orbit_integer(factor) + (way == 8);
    switch (way) {
    case 1:
        return (double)steps / orbit->iterations;
    case 7:
    case 8:
        return period > 0 ? steps % period / factor : 0;
    default:
        return factor * orbit_end(way, x, y);
    }
}

/* Whether the inside is of one colour, wherever its orbits end. */
static bool orbit_is_even(const struct orbit *orbit)
{
    int way = orbit_integer(orbit->interior[0]);
    return way < 1 || way > 6;
}

/* Stayed where it is for all steps. The sixth way is not that of the exterior
 * (measured). */
static double orbit_interior(const struct orbit *orbit, double nearest,
                             double x, double y)
{
    double factor = orbit->interior[1];
    int way = orbit_integer(orbit->interior[0]);
    if (way == 6)
        return x * x + factor * y * y;
    return factor * (way == 1 ? sqrt(nearest) : orbit_end(way, x, y));
}

struct complex {
    double x, y;
};

INLINED struct complex complex_make(double x, double y)
{
    return (struct complex){ x, y };
}

INLINED struct complex complex_add(struct complex a, struct complex b)
{
    return complex_make(a.x + b.x, a.y + b.y);
}

INLINED struct complex complex_mul(struct complex a, struct complex b)
{
    return complex_make(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

INLINED double complex_square(struct complex a)
{
    return a.x * a.x + a.y * a.y;
}

/* The square of a / b. */
INLINED struct complex complex_ratio_squared(struct complex a, struct complex b)
{
    double size = complex_square(b);
    struct complex ratio = complex_mul(a, complex_make(b.x, -b.y));
    ratio = complex_make(ratio.x / size, ratio.y / size);
    return complex_mul(ratio, ratio);
}

/* Peitgen and Richter, The Beauty of Fractals, 1986, pages 129 and 130:
 *     ((z^2 + c - 1) / (2 z + c - 2))^2 and
 *     ((z^3 + 3 (c-1) z + (c-1)(c-2)) /
 *      (3 z^2 + 3 (c-2) z + (c-1)(c-2) + 1))^2.
 * Orbits magnify rounding up to what is seen: the first map's sums are in
 * POV-Ray's order (measured: all points of a picture are the same). */
INLINED struct complex magnet_step(int kind, struct complex z, struct complex c)
{
    struct complex square = complex_mul(z, z);
    struct complex c1 = complex_make(c.x - 1, c.y);
    struct complex c2 = complex_make(c.x - 2, c.y);
    if (kind == 1)
        return complex_ratio_squared(
            complex_make(square.x + c.x - 1, square.y + c.y),
            complex_make(2 * z.x + c.x - 2, 2 * z.y + c.y));
    struct complex both = complex_mul(c1, c2),
                   z3 = complex_make(3 * z.x, 3 * z.y);
    struct complex above = complex_add(complex_mul(square, z), both);
    struct complex below = complex_mul(z3, complex_add(z, c2));
    above = complex_add(above, complex_mul(z3, c1));
    below = complex_add(below, complex_make(both.x + 1, both.y));
    return complex_ratio_squared(above, below);
}

/* Orbits as far as they are known: where they are, and the least squares of
 * their distances from the origin. */
struct orbits {
    LANE_LINES double x[SPOTS_MAX], y[SPOTS_MAX], u[SPOTS_MAX], v[SPOTS_MAX];
    double nearest[SPOTS_MAX];
    lane_flag live[SPOTS_MAX]; /* that are still followed */
    bool left[SPOTS_MAX];
    int steps[SPOTS_MAX]; /* that were in the circle; of those that left it */
    int end[SPOTS_MAX];   /* steps in all */
    int lanes;            /* whole octets */
};

/* Maps z -> z^n + c are named by n, magnet's by these. */
enum { MAGNET_1 = -1, MAGNET_2 = -2 };

enum { STRIDE = 8 }; /* steps between looks at who has left */

/* Steps that all take, as if none had left. */
struct stride {
    LANE_LINES double x[STRIDE][SPOTS_MAX], y[STRIDE][SPOTS_MAX];
    double square[STRIDE][SPOTS_MAX];
    lane_flag leaves[STRIDE][SPOTS_MAX];
};

INLINED struct complex orbit_next(int map, struct complex z, struct complex c)
{
    struct complex power = z;
    if (map < 0)
        return magnet_step(-map, z, c);
    for (int i = 1; i < map; i++)
        power = complex_mul(power, z);
    return complex_add(power, c);
}

/* Outside is also what comes to a magnet's fixed point, 1 (measured, as are the
 * limits). */
INLINED bool orbit_stays_in(int map, struct complex z, double square)
{
    const double far = 1e4, near = 1e-4;
    double off = (z.x - 1) * (z.x - 1) + z.y * z.y;
    return map > 0 ? !(square > 4) : (square <= far) & (off >= near);
}

/* From where they are. Returns not 0 if any leaves. */
INLINED lane_flag stride_walk(struct stride *restrict stride,
                              const struct orbits *restrict orbits, int map)
{
    lane_flag any = 0;
    const int lanes = orbits->lanes;
    for (int i = 0; i < lanes; i++) {
        struct complex z = { orbits->x[i], orbits->y[i] };
        struct complex c = { orbits->u[i], orbits->v[i] };
        lane_flag left = 0;
#pragma GCC unroll 8
        for (int k = 0; k < STRIDE; k++) {
            z = orbit_next(map, z, c);
            double square = complex_square(z);
            lane_flag leaves = orbit_stays_in(map, z, square) ? 0 : -1;
            stride->x[k][i] = z.x;
            stride->y[k][i] = z.y;
            stride->square[k][i] = square;
            stride->leaves[k][i] = leaves;
            left |= leaves;
        }
        any |= left & orbits->live[i];
    }
    return any;
}

/* Compiled for each of the usual maps, which decide the time. */
#define STRIDE_TAKE(name, map)                                                 \
    CLONES static lane_flag name(struct stride *restrict stride,               \
                                 const struct orbits *restrict orbits)         \
    {                                                                          \
        return stride_walk(stride, orbits, map);                               \
    }
STRIDE_TAKE(take_squares, 2)
STRIDE_TAKE(take_cubes, 3)
STRIDE_TAKE(take_magnets_1, MAGNET_1)
STRIDE_TAKE(take_magnets_2, MAGNET_2)

static lane_flag stride_take(struct stride *stride, const struct orbits *orbits,
                             int map)
{
    if (map == 2)
        return take_squares(stride, orbits);
    if (map == 3)
        return take_cubes(stride, orbits);
    if (map == MAGNET_1)
        return take_magnets_1(stride, orbits);
    if (map == MAGNET_2)
        return take_magnets_2(stride, orbits);
    return stride_walk(stride, orbits, map);
}

/* Whether one that is followed ends within the stride that begins after so
 * many steps; if so, where. */
static bool stride_ends(const struct stride *stride, struct orbits *orbits,
                        int i, int begun)
{
    int last = orbits->end[i] - 1 - begun, k = 0;
    double nearest = orbits->nearest[i];
    while (k < STRIDE && k <= last && !stride->leaves[k][i]) {
        double square = stride->square[k][i];
        nearest = square < nearest ? square : nearest;
        k++;
    }
    if (k == STRIDE && last >= STRIDE)
        return false;
    orbits->left[i] = k < STRIDE && k <= last;
    orbits->steps[i] = begun + k;
    k = orbits->left[i] ? k : last;
    orbits->x[i] = stride->x[k][i];
    orbits->y[i] = stride->y[k][i];
    orbits->nearest[i] = nearest;
    return true;
}

static void stride_settle(const struct stride *stride, struct orbits *orbits,
                          int begun)
{
    for (int i = 0; i < orbits->lanes; i++)
        if (orbits->live[i] && stride_ends(stride, orbits, i, begun))
            orbits->live[i] = 0;
}

/* Where orbits were once: one that is there again to the last bit goes round
 * for ever, and whole rounds, which change nothing, are left out (R. P. Brent,
 * "An improved Monte Carlo factorization algorithm", 1980, finds such cycles).
 */
struct orbits_seen {
    LANE_LINES double x[SPOTS_MAX], y[SPOTS_MAX];
    int steps, next; /* that were done then; and when to look again */
};

enum { CYCLE_FIRST = 16 }; /* steps before a cycle is looked for */

/* Those that are still followed are where it led. Returns not 0 if any is
 * there again. */
CLONES static lane_flag stride_go(const struct stride *restrict stride,
                                  const struct orbits_seen *restrict seen,
                                  struct orbits *restrict orbits)
{
    lane_flag again = 0;
    const int lanes = orbits->lanes;
    for (int i = 0; i < lanes; i++) {
        const double x = stride->x[STRIDE - 1][i];
        const double y = stride->y[STRIDE - 1][i];
        bool live = orbits->live[i] != 0;
        double nearest = orbits->nearest[i];
        for (int k = 0; k < STRIDE; k++) {
            double square = stride->square[k][i];
            nearest = square < nearest ? square : nearest;
        }
        orbits->nearest[i] = live ? nearest : orbits->nearest[i];
        orbits->x[i] = live ? x : orbits->x[i];
        orbits->y[i] = live ? y : orbits->y[i];
        again |= (live & (x == seen->x[i]) & (y == seen->y[i])) ? -1 : 0;
    }
    return again;
}

static void orbits_cut(struct orbits *orbits, const struct orbits_seen *seen,
                       int done)
{
    int round = done - seen->steps;
    for (int i = 0; i < orbits->lanes; i++) {
        if (orbits->x[i] != seen->x[i] || orbits->y[i] != seen->y[i])
            continue;
        orbits->end[i] = done + (orbits->end[i] - done) % round;
        if (orbits->end[i] <= done)
            orbits->live[i] = 0;
    }
}

/* The first end. */
static int orbits_end(const struct orbits *orbits)
{
    int first = INT_MAX;
    for (int i = 0; i < orbits->lanes; i++)
        if (orbits->live[i] && orbits->end[i] < first)
            first = orbits->end[i];
    return first;
}

static void orbits_see(const struct orbits *orbits, struct orbits_seen *seen,
                       int done)
{
    for (int i = 0; i < orbits->lanes; i++) {
        seen->x[i] = orbits->x[i];
        seen->y[i] = orbits->y[i];
    }
    seen->steps = done;
    seen->next = 2 * done;
}

/* Goes on until all orbits leave the circle of radius 2 or all steps are done.
 */
static void orbits_follow(struct orbits *restrict orbits, int map)
{
    struct stride stride;
    struct orbits_seen seen = { .next = CYCLE_FIRST };
    int end = orbits_end(orbits);
    for (int done = 0; end < INT_MAX;) {
        bool settle = stride_take(&stride, orbits, map) || done + STRIDE >= end;
        if (settle)
            stride_settle(&stride, orbits, done);
        lane_flag again = stride_go(&stride, &seen, orbits);
        done += STRIDE;
        if (again && seen.steps > 0) {
            orbits_cut(orbits, &seen, done);
            settle = true;
        }
        if (settle)
            end = orbits_end(orbits);
        if (done >= seen.next)
            orbits_see(orbits, &seen, done);
    }
}

/* Whether z -> z^2 + c, from z = c on, is known to stay: c is in the cardioid
 * or the disc whose orbits come to a point or to two (A. Douady and J. Hubbard,
 * Etude dynamique des polynomes complexes, 1984), and not so near their edges
 * that rounding could lead out. There orbits settle so slowly that they take
 * nearly all of a picture's time. */
static bool orbit_stays(double x, double y)
{
    const double margin = 1e-12;
    double right = x - 0.25, square = right * right + y * y;
    return square * (square + right) < 0.25 * y * y - margin ||
           (x + 1) * (x + 1) + y * y < 0.0625 - margin;
}

void orbit_starts_at(const struct orbit *orbit, const struct spots *spots,
                     struct orbit_starts *starts)
{
    starts->count = spots->count;
    for (int i = 0; i < spots->count; i++) {
        starts->x[i] = spots->x[i];
        starts->y[i] = spots->y[i];
        starts->u[i] = orbit->constant[0];
        starts->v[i] = orbit->constant[1];
    }
}

static void orbits_start(struct orbits *orbits, const struct orbit *orbit,
                         const struct orbit_starts *starts)
{
    orbits->lanes = (starts->count + OCTET - 1) / OCTET * OCTET;
    for (int i = 0; i < orbits->lanes; i++) {
        int k = i < starts->count ? i : starts->count - 1;
        orbits->x[i] = starts->x[k];
        orbits->y[i] = starts->y[k];
        orbits->u[i] = starts->u[k];
        orbits->v[i] = starts->v[k];
        orbits->nearest[i] =
            complex_square(complex_make(starts->x[k], starts->y[k]));
        orbits->end[i] = orbit->iterations;
        orbits->left[i] = false;
        orbits->live[i] = i < starts->count && orbit->iterations > 0 ? -1 : 0;
    }
}

static void orbits_finish(const struct orbits *orbits,
                          const struct orbit *orbit, int count, double *values)
{
    for (int i = 0; i < count; i++) {
        double x = orbits->x[i], y = orbits->y[i];
        values[i] = orbits->left[i]
                        ? orbit_exterior(orbit, orbits->steps[i], x, y)
                        : orbit_interior(orbit, orbits->nearest[i], x, y);
    }
}

void orbit_values(const struct orbit *orbit, const struct orbit_starts *starts,
                  double *values)
{
    struct orbits orbits;
    bool may_stay = orbit->exponent == 2 && orbit_is_even(orbit);
    orbits_start(&orbits, orbit, starts);
    for (int i = 0; may_stay && i < starts->count; i++) {
        double x = orbits.x[i], y = orbits.y[i];
        if (x == orbits.u[i] && y == orbits.v[i] && orbit_stays(x, y))
            orbits.live[i] = 0;
    }
    orbits_follow(&orbits, orbit->exponent);
    orbits_finish(&orbits, orbit, starts->count, values);
}

void orbit_magnets(const struct orbit *orbit, const struct orbit_starts *starts,
                   double *values)
{
    struct orbits orbits;
    orbits_start(&orbits, orbit, starts);
    for (int i = 0; !orbit->julia && i < starts->count; i++)
        orbits.nearest[i] = (double)INFINITY;
    orbits_follow(&orbits, orbit->magnet == 1 ? MAGNET_1 : MAGNET_2);
    orbits_finish(&orbits, orbit, starts->count, values);
}
