/* Orbits and what they are coloured by, as measured: see orbit.h. */
#include "scene/orbit.h"

#include <math.h>

/* (x + iy)^n into *x, *y. */
static void complex_power(double *x, double *y, int n)
{
    double a = *x, b = *y;
    for (int i = 1; i < n; i++) {
        double real = *x * a - *y * b;
        *y = *x * b + *y * a;
        *x = real;
    }
}

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

/* Stayed where it is for all steps. */
static double orbit_interior(const struct orbit *orbit, double nearest,
                             double x, double y)
{
    int way = orbit_integer(orbit->interior[0]);
    return orbit->interior[1] *
           (way == 1 ? sqrt(nearest) : orbit_end(way, x, y));
}

enum { CYCLE_FIRST = 15 }; /* steps before a cycle is looked for */

/* An orbit as far as it is known: where it is, and the least square of its
 * distance from the origin. */
struct orbit_state {
    double x, y, nearest;
    int steps;
};

/* Goes on until the orbit leaves the circle of radius 2 and returns true, or
 * until all steps are done. Where it comes back to a place to the last bit, it
 * goes round for ever: whole rounds change nothing and are left out (R. P.
 * Brent, "An improved Monte Carlo factorization algorithm", 1980, finds such
 * cycles). Compiled for each exponent, as the power decides the time. */
static inline __attribute__((always_inline)) bool
orbit_leaves(struct orbit_state *orbit, int end, int exponent, double u,
             double v)
{
    double x = orbit->x, y = orbit->y, nearest = orbit->nearest;
    double seen_x = x, seen_y = y;
    int i, seen = 0, look = CYCLE_FIRST;
    bool leaves = false;
    for (i = 0; i < end; i++) {
        complex_power(&x, &y, exponent);
        x += u;
        y += v;
        double square = x * x + y * y;
        leaves = square > 4;
        if (leaves)
            break;
        nearest = square < nearest ? square : nearest;
        if (x == seen_x && y == seen_y && seen > 0)
            i = end - 1 - (end - 1 - i) % (i - seen);
        if (i == look) {
            seen_x = x;
            seen_y = y;
            seen = look;
            look = 2 * look + 1;
        }
    }
    *orbit = (struct orbit_state){ x, y, nearest, i };
    return leaves;
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

double orbit_value(const struct orbit *orbit, double x, double y, double u,
                   double v)
{
    if (orbit->exponent == 2 && x == u && y == v && orbit_is_even(orbit) &&
        orbit_stays(x, y))
        return orbit_interior(orbit, 0, x, y);
    struct orbit_state state = { x, y, x * x + y * y, 0 };
    int end = orbit->iterations;
    bool leaves;
    switch (orbit->exponent) {
    case 2:
        leaves = orbit_leaves(&state, end, 2, u, v);
        break;
    case 3:
        leaves = orbit_leaves(&state, end, 3, u, v);
        break;
    case 4:
        leaves = orbit_leaves(&state, end, 4, u, v);
        break;
    default:
        leaves = orbit_leaves(&state, end, orbit->exponent, u, v);
    }
    return leaves ? orbit_exterior(orbit, state.steps, state.x, state.y)
                  : orbit_interior(orbit, state.nearest, state.x, state.y);
}

struct complex {
    double x, y;
};

static struct complex complex_make(double x, double y)
{
    return (struct complex){ x, y };
}

static struct complex complex_add(struct complex a, struct complex b)
{
    return complex_make(a.x + b.x, a.y + b.y);
}

static struct complex complex_mul(struct complex a, struct complex b)
{
    return complex_make(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

/* The square of a / b. */
static struct complex complex_ratio_squared(struct complex a, struct complex b)
{
    double size = b.x * b.x + b.y * b.y;
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
static struct complex magnet_step(int kind, struct complex z, struct complex c)
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

/* Outside is also what comes to the map's fixed point, 1 (measured, as are the
 * limits). */
double orbit_magnet(const struct orbit *orbit, double x, double y, double u,
                    double v)
{
    const double far = 1e4, near = 1e-4;
    struct complex z = { x, y }, c = { u, v };
    double nearest = orbit->julia ? x * x + y * y : (double)INFINITY;
    for (int i = 0; i < orbit->iterations; i++) {
        z = magnet_step(orbit->magnet, z, c);
        double square = z.x * z.x + z.y * z.y;
        double off = (z.x - 1) * (z.x - 1) + z.y * z.y;
        if (!(square <= far) || off < near)
            return orbit_exterior(orbit, i, z.x, z.y);
        nearest = square < nearest ? square : nearest;
    }
    return orbit_interior(orbit, nearest, z.x, z.y);
}
