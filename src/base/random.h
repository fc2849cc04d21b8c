/* Random numbers that depend on what is computed, never on a thread: a hash
 * of (seed, pixel, sample, dimension). */
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stdint.h>

/* A bijection of 64-bit words with good avalanche (SplitMix64's finaliser,
 * Steele, Lea and Flood 2014). */
static inline uint64_t random_mix(uint64_t x)
{
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/* One more word into a key. */
static inline uint64_t random_key(uint64_t key, uint64_t word)
{
    return random_mix(key ^ random_mix(word));
}

/* Uniform in [0, 1) with 53 bits. */
static inline double random_unit(uint64_t key)
{
    return (double)(random_mix(key) >> 11) * 0x1p-53;
}

/* The number after `state` in the sequence behind the scene language's rand():
 * a linear congruential generator modulo 2^32. Its constants were found by
 * measurement: what POV-Ray scatters with it must land in the same places. */
static inline uint32_t random_step(uint32_t state)
{
    return state * 1812433253u + 12345u;
}

/* The next 15 bits of it, as POV-Ray draws numbers for its tables. */
static inline uint32_t random_bits(uint32_t *state)
{
    *state = random_step(*state);
    return *state >> 16 & 0x7fff;
}

#endif
