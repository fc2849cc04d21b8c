/* Low-discrepancy random numbers of Monte Carlo integration: the first two
 * dimensions of Sobol's sequence, shuffled and scrambled after Owen by hashing
 * (Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020), padded: each
 * slot has a scrambling of its own. A number depends on (key, index, slot). */
#ifndef BASE_DRAW_H
#define BASE_DRAW_H

#include <math.h>
#include <stddef.h>

#include "base/random.h"

/* Sample `index` of the integral that `key` names. */
struct draws {
    uint64_t key;
    uint32_t index;
};

/* A pair in [0,1)^2. Over the indices 0..2^n-1 the pairs of one slot are a
 * (0,n,2)-net in base 2; slots are independent. */
void draw_pair(const struct draws *draws, uint32_t slot, double pair[2]);

/* What scrambles a slot of a key: one for all indices. */
struct draw_slot {
    uint32_t order, first, second;
};

struct draw_slot draw_slot_of(uint64_t key, uint32_t slot);

/* Pairs of so many slots and indices at a time, to the bit as draw_pair's. */
enum { DRAW_LANES = 16 };

struct draw_lanes {
    uint32_t order[DRAW_LANES], first[DRAW_LANES], second[DRAW_LANES];
    uint32_t index[DRAW_LANES];
};

void draw_pairs(const struct draw_lanes *lanes, double *x, double *y);

/* The first number of a slot's pair. */
double draw_unit(const struct draws *draws, uint32_t slot);

/* The same samples with slots of their own, for a part of the integrand. */
struct draws draws_within(const struct draws *draws, uint64_t part);

/* Moves a place in [0,1)^2 on by `number` >= 0: any of them in a row are evenly
 * spread, however many there are (Roberts, The Unreasonable Effectiveness of
 * Quasirandom Sequences, 2018). */
static inline void draw_further(double number, double *x, double *y)
{
    *x += number * 0.7548776662466927;
    *y += number * 0.5698402909980532;
    *x -= floor(*x);
    *y -= floor(*y);
}

/* The item in whose share of a total `which`, in [0,1), lies: sums[i] is that
 * of items 0..i. There must be one. *share is its part of the total. */
size_t draw_share(const double *sums, size_t count, double which,
                  double *share);

#endif
