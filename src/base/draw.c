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

/* Owen's nested uniform scrambling, from the highest bit down. */
static uint32_t bits_scrambled(uint32_t x, uint32_t seed)
{
    return bits_reversed(bits_permuted(bits_reversed(x), seed));
}

/* The second dimension: Pascal's triangle modulo 2. */
static uint32_t sobol_second(uint32_t index)
{
    uint32_t result = 0;
    for (uint32_t v = 1u << 31; index; index >>= 1, v ^= v >> 1)
        if (index & 1)
            result ^= v;
    return result;
}

void draw_pair(const struct draws *draws, uint32_t slot, double pair[2])
{
    uint64_t key = random_key(draws->key, slot), more = random_mix(key);
    uint32_t index = bits_scrambled(draws->index, (uint32_t)key);
    uint32_t first =
        bits_scrambled(bits_reversed(index), (uint32_t)(key >> 32));
    uint32_t second = bits_scrambled(sobol_second(index), (uint32_t)more);
    pair[0] = first * 0x1p-32;
    pair[1] = second * 0x1p-32;
}

double draw_unit(const struct draws *draws, uint32_t slot)
{
    double pair[2];
    draw_pair(draws, slot, pair);
    return pair[0];
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
