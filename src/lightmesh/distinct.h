/* How many different keys were seen, about: a bit for the hash of each, and how
 * many they are follows from the share of zeros (linear counting: Whang et al.
 * 1990, A Linear-Time Probabilistic Counting Algorithm). Good to 1 % up to half
 * a million. */
#ifndef LIGHTMESH_DISTINCT_H
#define LIGHTMESH_DISTINCT_H

#include <math.h>
#include <stdint.h>

#include "base/random.h"

enum { DISTINCT_WORDS = 2048, DISTINCT_BITS = 64 * DISTINCT_WORDS };

/* Begins zeroed. */
struct distinct {
    uint64_t words[DISTINCT_WORDS];
};

static inline void distinct_add(struct distinct *seen, uint64_t key)
{
    uint64_t bit = random_mix(key) % DISTINCT_BITS;
    seen->words[bit / 64] |= 1ull << bit % 64;
}

static inline double distinct_count(const struct distinct *seen)
{
    int zeros = DISTINCT_BITS;
    for (int i = 0; i < DISTINCT_WORDS; i++) /* most are 0 */
        if (seen->words[i])
            zeros -= __builtin_popcountll(seen->words[i]);
    return -DISTINCT_BITS *
           log((zeros > 0 ? zeros : 1) / (double)DISTINCT_BITS);
}

#endif
