/* See octet_math.h. A number alone is worked out as one of a pair. */
#include "base/octet_math.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "base/clones.h"
#include "base/pair.h"
#include "base/quad.h"

typedef int64_t pair_bits __attribute__((vector_size(PAIR * sizeof(int64_t))));

INLINED pair pair_choose(pair_bits where, pair yes, pair no)
{
    return (pair)((where & (pair_bits)yes) | (~where & (pair_bits)no));
}

INLINED pair_bits pair_less(pair a, pair b)
{
    return a < b;
}

#define NUMBERS     pair
#define BITS        pair_bits
#define NAMED(name) pair_##name
#include "base/angles.h"
#undef NUMBERS
#undef BITS
#undef NAMED

#define NUMBERS     quad
#define BITS        quad_bits
#define NAMED(name) quad_##name
#include "base/angles.h"

/* Beyond it a multiple of the first part of pi/2 is not exact. */
static const double angle_limit = 1e8;

static const double arc_limit = 1e150;

INLINED bool quad_within(quad x, double limit)
{
    const quad most = (quad){ 0 } + limit;
    const quad_bits within = quad_magnitude(x) <= most;
    return (within[0] & within[1] & within[2] & within[3]) != 0;
}

/* The sines of four and `ahead` quarter turns. */
INLINED void quads_sine(octet *x, int from, int64_t ahead)
{
    const quad at = quad_of(x, from);
    if (quad_within(at, angle_limit))
        quad_into(x, from, quad_sine_ahead(at, ahead));
    else
        for (int i = from; i < from + QUAD; i++)
            (*x)[i] = ahead ? lone_cos((*x)[i]) : lone_sin((*x)[i]);
}

CLONES void octet_sin(octet *x)
{
    for (int from = 0; from < OCTET; from += QUAD)
        quads_sine(x, from, 0);
}

CLONES void octet_cos(octet *x)
{
    for (int from = 0; from < OCTET; from += QUAD)
        quads_sine(x, from, 1);
}

INLINED void quads_arc(octet *y, const octet *x, int from)
{
    const quad high = quad_of(y, from), across = quad_of(x, from);
    if (quad_within(high, arc_limit) && quad_within(across, arc_limit))
        quad_into(y, from, quad_arc_of(high, across));
    else
        for (int i = from; i < from + QUAD; i++)
            (*y)[i] = lone_atan2((*y)[i], (*x)[i]);
}

CLONES void octet_atan2(octet *y, const octet *x)
{
    for (int from = 0; from < OCTET; from += QUAD)
        quads_arc(y, x, from);
}

CLONES void octet_sqrt(octet *x)
{
    double *at = (double *)x;
    for (int i = 0; i < OCTET; i++)
        at[i] = sqrt(at[i]);
}

CLONES void octet_abs(octet *x)
{
    *x = (octet)((octet_bits)*x & INT64_MAX);
}

/* ln 2; the first part of it ends in zeros, so that whole multiples of it are
 * exact. */
static const double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;

/* Added to a number it leaves its whole part in the last bits. */
static const double whole = 0x1.8p52;

INLINED octet octet_clamp(octet x, double least, double most)
{
    const octet none = { 0 }, low = none + least, high = none + most;
    x = octet_choose(octet_less(x, low), low, x);
    return octet_choose(octet_less(high, x), high, x);
}

/* parts[0] + parts[1] x + parts[2] x^2 ... of an even number of parts, those of
 * even and of odd powers in two sums that need not wait for each other. */
INLINED octet octet_series(octet x, const double *parts, int count)
{
    const octet square = x * x;
    octet even = x * 0 + parts[count - 2], odd = x * 0 + parts[count - 1];
#pragma GCC unroll 16
    for (int i = count - 4; i >= 0; i -= 2) {
        even = even * square + parts[i];
        odd = odd * square + parts[i + 1];
    }
    return even + odd * x;
}

/* 2^k e^r, r at most ln 2 / 2: the series of that. */
CLONES void octet_exp(octet *x)
{
    static const double parts[] = {
        1,
        1,
        1.0 / 2,
        1.0 / 6,
        1.0 / 24,
        1.0 / 120,
        1.0 / 720,
        1.0 / 5040,
        1.0 / 40320,
        1.0 / 362880,
        1.0 / 3628800,
        1.0 / 39916800,
        1.0 / 479001600,
        1.0 / 6227020800,
    };
    const octet clamped = octet_clamp(*x, -708, 708);
    const octet shifted = clamped * (1 / 0x1.62e42fefa39efp-1) + whole;
    const octet k = shifted - whole;
    const octet r = (clamped - k * ln2_high) - k * ln2_low;
    const octet_bits power = (octet_bits)(((octet_bits)shifted + 1023) << 52);
    *x = octet_series(r, parts, sizeof parts / sizeof *parts) * (octet)power;
}

/* x = 2^k m, m from the root of 1/2 to that of 2; with s = (m - 1) / (m + 1)
 * its logarithm is 2 (s + s^3 / 3 + s^5 / 5 + ...). */
CLONES void octet_ln(octet *x)
{
    static const double parts[] = {
        1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
        1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21,
    };
    const int64_t root = 0x3fe6a09e667f3bcd;
    const octet_bits bits = (octet_bits)octet_clamp(*x, 1e-300, HUGE_VAL);
    const octet_bits power = (bits - root) >> 52;
    const octet m = (octet)(bits - (power << 52));
    const octet k = (octet)(power + (octet_bits)(*x * 0 + whole)) - whole;
    const octet s = (m - 1) / (m + 1), square = s * s;
    const octet sum = octet_series(square, parts, sizeof parts / sizeof *parts);
    *x = k * ln2_high + (2 * s + (2 * s * square * sum + k * ln2_low));
}

double lone_sin(double x)
{
    return fabs(x) <= angle_limit ? pair_sine_ahead(pair_of(x), 0)[0] : sin(x);
}

double lone_cos(double x)
{
    return fabs(x) <= angle_limit ? pair_sine_ahead(pair_of(x), 1)[0] : cos(x);
}

double lone_atan2(double y, double x)
{
    if (!(fabs(y) <= arc_limit && fabs(x) <= arc_limit))
        return atan2(y, x);
    return pair_arc_of(pair_of(y), pair_of(x))[0];
}

void numbers_sin(double *x, int count)
{
    for (; count > 2; x += OCTET, count -= OCTET) {
        const size_t size = (size_t)(count < OCTET ? count : OCTET) * sizeof *x;
        octet each = { 0 };
        memcpy(&each, x, size);
        octet_sin(&each);
        memcpy(x, &each, size);
    }
    for (int i = 0; i < count; i++)
        x[i] = lone_sin(x[i]);
}

void numbers_atan2(double *y, const double *x, int count)
{
    for (; count > 2; y += OCTET, x += OCTET, count -= OCTET) {
        const size_t size = (size_t)(count < OCTET ? count : OCTET) * sizeof *y;
        octet each = { 0 }, beside = { 0 };
        memcpy(&each, y, size);
        memcpy(&beside, x, size);
        octet_atan2(&each, &beside);
        memcpy(y, &each, size);
    }
    for (int i = 0; i < count; i++)
        y[i] = lone_atan2(y[i], x[i]);
}
