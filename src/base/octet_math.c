/* See octet_math.h. A number alone is worked out as one of a pair. */
#include "base/octet_math.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/clones.h"
#include "base/pair.h"

typedef int64_t pair_bits __attribute__((vector_size(PAIR * sizeof(int64_t))));
typedef int64_t octet_bits
    __attribute__((vector_size(OCTET * sizeof(int64_t))));

/* No vector is handed on but within a function for one kind of processor. */
#pragma GCC diagnostic ignored "-Wpsabi"
#define INLINED __attribute__((always_inline)) static inline

#define NUMBERS     pair
#define BITS        pair_bits
#define NAMED(name) pair_##name
#include "base/angles.h"
#undef NUMBERS
#undef BITS
#undef NAMED

#define NUMBERS     octet
#define BITS        octet_bits
#define NAMED(name) octet_##name
#include "base/angles.h"

/* Beyond it a multiple of the first part of pi/2 is not exact. */
static const double angle_limit = 1e6;

static const double arc_limit = 1e150;

INLINED bool octet_within(const octet *x, double limit)
{
    const octet_bits within = octet_magnitude(*x) <= limit;
    int64_t all = -1;
    for (int i = 0; i < OCTET; i++)
        all &= within[i];
    return all != 0;
}

CLONES void octet_sin(octet *x)
{
    if (octet_within(x, angle_limit))
        *x = octet_sine_ahead(*x, 0);
    else
        for (int i = 0; i < OCTET; i++)
            (*x)[i] = lone_sin((*x)[i]);
}

CLONES void octet_cos(octet *x)
{
    if (octet_within(x, angle_limit))
        *x = octet_sine_ahead(*x, 1);
    else
        for (int i = 0; i < OCTET; i++)
            (*x)[i] = lone_cos((*x)[i]);
}

CLONES void octet_atan2(octet *y, const octet *x)
{
    if (octet_within(y, arc_limit) && octet_within(x, arc_limit))
        *y = octet_arc_of(*y, *x);
    else
        for (int i = 0; i < OCTET; i++)
            (*y)[i] = lone_atan2((*y)[i], (*x)[i]);
}

CLONES void octet_sqrt(octet *x)
{
    double *at = (double *)x;
    for (int i = 0; i < OCTET; i++)
        at[i] = sqrt(at[i]);
}

CLONES void octet_abs(octet *x)
{
    *x = octet_magnitude(*x);
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
