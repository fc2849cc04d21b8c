/* Owen-scrambled Sobol pairs: see draw.h. */
#include "base/draw.h"

static uint32_t bits_reversed(uint32_t x)
{
    x = x << 16 | x >> 16;
    x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
    x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
    x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
    return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
}

/* Each bit changes by a hash of the lower ones (Laine and Karras 2011, with
 * the constants of Burley's listing 2). */
static uint32_t bits_permuted(uint32_t x, uint32_t seed)
{
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    return x ^ x * 0x8d22f6e6u;
}

/* Owen's nested uniform scrambling, from the highest bit down, of a number
 * whose bits are given in reverse. */
static uint32_t bits_scrambled(uint32_t reversed, uint32_t seed)
{
    return bits_reversed(bits_permuted(reversed, seed));
}

/* The second dimension, its bits in reverse: Pascal's triangle modulo 2, in
 * which bit k is of all bits whose numbers have those of k (Lucas' theorem). */
static uint32_t sobol_second(uint32_t x)
{
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ x >> 16;
}

/* The place of the sample in the sequence of the slot. */
static uint32_t draw_index(const struct draws *draws, uint64_t key)
{
    return bits_scrambled(bits_reversed(draws->index), (uint32_t)key);
}

static double draw_first(uint32_t index, uint64_t key)
{
    return bits_scrambled(index, (uint32_t)(key >> 32)) * 0x1p-32;
}

void draw_pair(const struct draws *draws, uint32_t slot, double pair[2])
{
    uint64_t key = random_key(draws->key, slot);
    uint32_t index = draw_index(draws, key);
    pair[0] = draw_first(index, key);
    pair[1] = bits_scrambled(sobol_second(index), (uint32_t)random_mix(key)) *
              0x1p-32;
}

double draw_unit(const struct draws *draws, uint32_t slot)
{
    uint64_t key = random_key(draws->key, slot);
    return draw_first(draw_index(draws, key), key);
}

struct draws draws_within(const struct draws *draws, uint64_t part)
{
    return (struct draws){ random_key(draws->key, part), draws->index };
}

size_t draw_share(const double *sums, size_t count, double which, double *share)
{
    double total = sums[count - 1], wanted = which * total;
    size_t low = 0, high = count - 1;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (sums[middle] > wanted)
            high = middle;
        else
            low = middle + 1;
    }
    double before = low ? sums[low - 1] : 0;
    *share = total > 0 ? (sums[low] - before) / total : 1;
    return low;
}
