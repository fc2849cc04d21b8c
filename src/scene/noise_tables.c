/* The random numbers of POV-Ray's solid noise, recovered from what its
 * functions say at lattice points (tests/values asks both programs again).
 * All follow from formulas:
 * - A lattice point is hashed by a permutation of 4096 numbers, once for each
 *   coordinate. The permutation is a shuffle by the generator of rand().
 * - Four consecutive numbers of a list of 267 are twice the value of a lattice
 *   point and its gradient. The list is the CRC-16 of three equal big-endian
 *   doubles (as in the noise of C. Kolb's Rayshade, after R. Skinner), to six
 *   digits.
 * - The cells of `crackle` have their points from M. Matsumoto and T.
 *   Nishimura, "Mersenne Twister", ACM TOMACS 8, 1998: seed 5489.
 * - The waves of `ripples` spread from the directions of the vector noise at
 *   <0,0,0>, <1,0,0>, <2,0,0> ...; those of `waves` have random frequencies. */
#include "scene/noise_tables.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "base/random.h"

static struct noise_tables made;
static struct once tables_made;

static void make_permutation(uint16_t permutation[LATTICE_PERIOD])
{
    uint32_t state = 0;
    for (int i = 0; i < LATTICE_PERIOD; i++)
        permutation[i] = (uint16_t)i;
    for (int i = LATTICE_PERIOD - 1; i >= 0; i--) {
        uint32_t other = random_bits(&state) & LATTICE_MASK;
        uint16_t kept = permutation[i];
        permutation[i] = permutation[other];
        permutation[other] = kept;
    }
}

/* CRC-16/ARC of a double written three times, highest byte first. */
static uint16_t number_crc(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    uint16_t crc = 0;
    for (int i = 0; i < 24; i++) {
        crc ^= (uint16_t)(bits >> (56 - i % 8 * 8) & 0xff);
        for (int bit = 0; bit < 8; bit++)
            crc = (uint16_t)(crc >> 1 ^ (crc & 1 ? 0xa001 : 0));
    }
    return crc;
}

/* As long as its last window. */
enum { LATTICE_NUMBERS = NOISE_WINDOWS + NOISE_FIELDS * NOISE_NUMBERS - 1 };

static void make_lattice(float lattice[LATTICE_NUMBERS])
{
    for (int i = 0; i < LATTICE_NUMBERS; i++) {
        char digits[32];
        double number = number_crc(i * 0.12345) / 65535.0 * 2 - 1;
        snprintf(digits, sizeof digits, "%.6g", number);
        lattice[i] = strtof(digits, NULL);
    }
}

enum { MERSENNE_STATE = 624, MERSENNE_SHIFT = 397 };

static void mersenne_twist(uint32_t state[MERSENNE_STATE])
{
    for (int i = 0; i < MERSENNE_STATE; i++) {
        uint32_t bits = (state[i] & 0x80000000u) |
                        (state[(i + 1) % MERSENNE_STATE] & 0x7fffffffu);
        state[i] = state[(i + MERSENNE_SHIFT) % MERSENNE_STATE] ^ bits >> 1 ^
                   (bits & 1 ? 0x9908b0dfu : 0);
    }
}

static uint32_t mersenne_temper(uint32_t bits)
{
    bits ^= bits >> 11;
    bits ^= bits << 7 & 0x9d2c5680u;
    bits ^= bits << 15 & 0xefc60000u;
    return bits ^ bits >> 18;
}

static void make_cells(uint32_t *cells, int count)
{
    uint32_t state[MERSENNE_STATE] = { 5489 };
    for (int i = 1; i < MERSENNE_STATE; i++) {
        uint32_t before = state[i - 1] ^ state[i - 1] >> 30;
        state[i] = 1812433253u * before + (uint32_t)i;
    }
    for (int i = 0; i < count; i++) {
        if (i % MERSENNE_STATE == 0)
            mersenne_twist(state);
        cells[i] = mersenne_temper(state[i % MERSENNE_STATE]);
    }
}

/* What overlaps in the list is faster read apart. */
static void make_windows(struct noise_tables *tables)
{
    float lattice[LATTICE_NUMBERS];
    make_lattice(lattice);
    for (int i = 0; i < NOISE_WINDOWS; i++)
        for (int number = 0; number < NOISE_NUMBERS; number++) {
            const float *from = lattice + i + number;
            tables->first[i][number] = *from;
            for (int field = 0; field < NOISE_FIELDS; field++)
                tables->fields[i][number][field] = from[NOISE_NUMBERS * field];
        }
}

/* At a lattice point the noise is half the first of a field's numbers. */
static vec3 lattice_vector(const struct noise_tables *tables, int x)
{
    uint32_t hash = lattice_hash(tables, lattice_plane(x), lattice_plane(0),
                                 lattice_plane(0));
    const float *value = tables->fields[hash % NOISE_WINDOWS][0];
    return vec3_scale(
        vec3_make((double)value[0], (double)value[1], (double)value[2]), 0.5);
}

/* The frequencies are the generator's from seed 1 on, after what its other
 * uses have taken. */
static void make_waves(struct noise_tables *tables)
{
    enum { TAKEN = 7168 };
    uint32_t state = 1;
    for (int i = 0; i < TAKEN; i++)
        state = random_step(state);
    for (int i = 0; i < NOISE_WAVES_LIMIT; i++) {
        vec3 source = vec3_normalise(lattice_vector(tables, i));
        tables->wave_source[0][i] = source.x;
        tables->wave_source[1][i] = source.y;
        tables->wave_source[2][i] = source.z;
        tables->wave_frequency[i] = random_bits(&state) / 32767.0 + 0.01;
    }
}

static void make_tables(void)
{
    make_permutation(made.permutation);
    make_windows(&made);
    make_cells(made.cells, LATTICE_PERIOD + 2);
    make_waves(&made);
}

const struct noise_tables *noise_tables(void)
{
    once_only(&tables_made, make_tables);
    return &made;
}
