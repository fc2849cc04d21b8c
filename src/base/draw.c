/* Owen-scrambled Sobol pairs: see draw.h. */
#include "base/draw.h"

#include "base/clones.h"

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

/* The number that 32 bits, the highest first, are behind the point. */
static double bits_fraction(uint32_t bits)
{
    return bits * 0x1p-32;
}

struct draw_slot draw_slot_of(uint64_t key, uint32_t slot)
{
    uint64_t own = random_key(key, slot);
    return (struct draw_slot){ .order = (uint32_t)own,
                               .first = (uint32_t)(own >> 32),
                               .second = (uint32_t)random_mix(own) };
}

/* The place of the sample in the sequence of the slot. */
static uint32_t draw_index(uint32_t index, uint32_t order)
{
    return bits_scrambled(bits_reversed(index), order);
}

void draw_pair(const struct draws *draws, uint32_t slot, double pair[2])
{
    struct draw_slot own = draw_slot_of(draws->key, slot);
    uint32_t index = draw_index(draws->index, own.order);
    pair[0] = bits_fraction(bits_scrambled(index, own.first));
    pair[1] = bits_fraction(bits_scrambled(sobol_second(index), own.second));
}

CLONES void draw_pairs(const struct draw_lanes *restrict lanes,
                       double *restrict x, double *restrict y)
{
    for (int i = 0; i < DRAW_LANES; i++) {
        uint32_t index = draw_index(lanes->index[i], lanes->order[i]);
        uint32_t second = sobol_second(index);
        x[i] = bits_fraction(bits_scrambled(index, lanes->first[i]));
        y[i] = bits_fraction(bits_scrambled(second, lanes->second[i]));
    }
}

double draw_unit(const struct draws *draws, uint32_t slot)
{
    struct draw_slot own = draw_slot_of(draws->key, slot);
    uint32_t index = draw_index(draws->index, own.order);
    return bits_fraction(bits_scrambled(index, own.first));
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
