/* The random numbers of solid noise; see noise_tables.c for what they are. */
#ifndef SCENE_NOISE_TABLES_H
#define SCENE_NOISE_TABLES_H

#include <stdint.h>

#include "base/vec.h"
#include "scene/noise.h"
#include "scene/noise_cell.h"

enum {
    LATTICE_PERIOD = 4096,
    LATTICE_MASK = LATTICE_PERIOD - 1,
    NOISE_WINDOWS = 256, /* hashes that differ in the numbers they stand for */
    NOISE_NUMBERS = 4,   /* of a lattice point: twice its value, its gradient */
    NOISE_FIELDS = 3,
    NOISE_ROOM = 4, /* for each of the numbers of three fields */
};

struct noise_tables {
    uint16_t permutation[LATTICE_PERIOD];
    /* Of the noise, which is the first field, and of the fields, number by
     * number; the last one of four means nothing. All in [-1,1]. */
    _Alignas(64) float first[NOISE_WINDOWS][NOISE_NUMBERS];
    _Alignas(64) float fields[NOISE_WINDOWS][NOISE_NUMBERS][NOISE_ROOM];
    uint32_t cells[LATTICE_PERIOD + 2];
    double wave_source[3][NOISE_WAVES_LIMIT]; /* unit vectors */
    double wave_frequency[NOISE_WAVES_LIMIT];
};

/* The same for all threads, made by the first call. */
const struct noise_tables *noise_tables(void);

/* The number of the lattice plane through 0. */
enum { LATTICE_ORIGIN = 10000 };

static inline uint32_t lattice_plane(int64_t plane)
{
    return (uint32_t)(plane + LATTICE_ORIGIN) & LATTICE_MASK;
}

/* In [0, LATTICE_PERIOD) for three numbers in that range. */
static inline uint32_t lattice_hash(const struct noise_tables *tables,
                                    uint32_t x, uint32_t y, uint32_t z)
{
    const uint16_t *permutation = tables->permutation;
    return permutation[permutation[permutation[x] ^ y] ^ z];
}

/* The random point of the cell whose planes, as numbers without an offset, have
 * this hash: in the unit cube. */
static inline vec3 noise_cell_inner(const struct noise_tables *tables,
                                    uint32_t hash)
{
    const double unit = 0x1p-32;
    const uint32_t *random = &tables->cells[hash];
    return vec3_make(random[0] * unit, random[1] * unit, random[2] * unit);
}

#endif
