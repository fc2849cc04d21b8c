/* See pair_math.h. Angles are taken modulo pi/2, which is subtracted in three
 * parts of 33 bits (Cody and Waite, "Software Manual for the Elementary
 * Functions", 1980). The polynomials are minimax ones: those of sine and cosine
 * between -pi/4 and pi/4 have the coefficients of Sun's fdlibm (1993), the
 * quotient of the arc tangent those of Moshier's Cephes library (1989). */
#include "base/pair_math.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

typedef int64_t pair_bits __attribute__((vector_size(PAIR * sizeof(int64_t))));

/* Number `yes` where the bits are set, else `no`. */
static inline pair choose(pair_bits where, pair yes, pair no)
{
    return (pair)((where & (pair_bits)yes) | (~where & (pair_bits)no));
}

static const pair_bits sign_bit = { INT64_MIN, INT64_MIN };

pair pair_abs(pair x)
{
    return (pair)((pair_bits)x & ~sign_bit);
}

static inline bool pair_within(pair x, double limit)
{
    pair size = pair_abs(x);
    return size[0] <= limit && size[1] <= limit;
}

/* Beyond it a multiple of the first part of pi/2 is not exact. */
static const double angle_limit = 1e6;

/* x as the quarter turns nearest to it, modulo 4 in the lowest bits, and the
 * rest. */
static inline pair_bits quarters(pair x, pair *rest)
{
    const double whole =
        0x1.8p52; /* so large that nothing is after the point */
    pair turned = x * 0x1.45f306dc9c883p-1 + whole, count = turned - whole;
    x = x - count * 1.57079632673412561417e+00;
    x = x - count * 6.07710050630396597660e-11;
    *rest = x - count * 2.02226624879595063154e-21;
    return (pair_bits)turned;
}

static inline pair sine_near(pair x, pair z)
{
    pair sum = 1.58969099521155010221e-10 * z - 2.50507602534068634195e-08;
    sum = sum * z + 2.75573137070700676789e-06;
    sum = sum * z - 1.98412698298579493134e-04;
    sum = sum * z + 8.33333333332248946124e-03;
    sum = sum * z - 1.66666666666666324348e-01;
    return x + x * z * sum;
}

static inline pair cosine_near(pair z)
{
    pair sum = -1.13596475577881948265e-11 * z + 2.08757232129817482790e-09;
    sum = sum * z - 2.75573143513906633035e-07;
    sum = sum * z + 2.48015872894767294178e-05;
    sum = sum * z - 1.38888888888741095749e-03;
    sum = sum * z + 4.16666666666666019037e-02;
    return 1 - (0.5 * z - z * z * sum);
}

/* The sine of x and `ahead` quarter turns. */
static inline pair sine_ahead(pair x, int64_t ahead)
{
    pair rest;
    pair_bits turns = quarters(x, &rest) + ahead;
    pair z = rest * rest;
    pair_bits odd = -(turns & 1), negative = (turns & 2) << 62;
    pair value = choose(odd, cosine_near(z), sine_near(rest, z));
    return (pair)((pair_bits)value ^ negative);
}

pair pair_sin(pair x)
{
    if (!pair_within(x, angle_limit))
        return (pair){ lone_sin(x[0]), lone_sin(x[1]) };
    return sine_ahead(x, 0);
}

pair pair_cos(pair x)
{
    if (!pair_within(x, angle_limit))
        return (pair){ lone_cos(x[0]), lone_cos(x[1]) };
    return sine_ahead(x, 1);
}

double lone_sin(double x)
{
    return fabs(x) <= angle_limit ? sine_ahead(pair_of(x), 0)[0] : sin(x);
}

double lone_cos(double x)
{
    return fabs(x) <= angle_limit ? sine_ahead(pair_of(x), 1)[0] : cos(x);
}

/* Of what is below the tangent of pi/8 or so. */
static inline pair arc_near(pair x)
{
    pair z = x * x;
    pair above = -8.750608600031904122785e-1 * z - 1.615753718733365076637e1;
    above = above * z - 7.500855792314704667340e1;
    above = above * z - 1.228866684490136173410e2;
    above = above * z - 6.485021904942025371773e1;
    pair below = z + 2.485846490142306297962e1;
    below = below * z + 1.650270098316988542046e2;
    below = below * z + 4.328810604912902668951e2;
    below = below * z + 4.853903996359136964868e2;
    below = below * z + 1.945506571482613964425e2;
    return x + x * (z * above / below);
}

/* Of numbers that are neither endless nor almost so. The angle of the eighth
 * of the plane, then of the half, then of the plane. */
static inline pair arc_of(pair y, pair x)
{
    const double pi_half = 0x1.921fb54442d18p0,
                 pi_half_rest = 0x1.1a62633145c07p-54;
    pair wide = pair_abs(x), high = pair_abs(y), zero = { 0, 0 };
    pair_bits steep = high > wide;
    pair large = choose(steep, high, wide), small = choose(steep, wide, high);
    pair slope = choose(large > zero, small / large, zero);
    pair_bits far = slope > 0.41421356237309503;
    pair near = choose(far, (slope - 1) / (slope + 1), slope);
    pair angle = arc_near(near);
    pair quarter = choose(far, pair_of(pi_half / 2), zero);
    pair rest = choose(far, pair_of(pi_half_rest / 2), zero);
    angle = quarter + (angle + rest);
    angle = choose(steep, pi_half - (angle - pi_half_rest), angle);
    pair_bits back = ((pair_bits)x & sign_bit) != 0;
    angle = choose(back, 2 * pi_half - (angle - 2 * pi_half_rest), angle);
    return (pair)((pair_bits)angle | ((pair_bits)y & sign_bit));
}

static const double arc_limit = 1e150;

pair pair_atan2(pair y, pair x)
{
    if (!pair_within(y, arc_limit) || !pair_within(x, arc_limit))
        return (pair){ lone_atan2(y[0], x[0]), lone_atan2(y[1], x[1]) };
    return arc_of(y, x);
}

double lone_atan2(double y, double x)
{
    if (!(fabs(y) <= arc_limit && fabs(x) <= arc_limit))
        return atan2(y, x);
    return arc_of(pair_of(y), pair_of(x))[0];
}

pair pair_sqrt(pair x)
{
    return (pair){ sqrt(x[0]), sqrt(x[1]) };
}
