/* Words are mixed in one after the other, by SplitMix64's finaliser (Steele,
 * Lea and Flood 2014); those of long data in lanes that need not wait for each
 * other, by one multiplication each. See hash.h. */
#include "base/hash.h"

#include <string.h>

#include "base/random.h"
#include "base/rgb.h"

enum { LANES = 8, ROW = LANES * sizeof(uint64_t), LONG = 128 };

/* A bijection, as all that a word goes through: no two words give the same. */
static inline uint64_t lane_mix(uint64_t lane, uint64_t word)
{
    lane = (lane ^ word) * 0xbf58476d1ce4e5b9ull;
    return lane ^ (lane >> 29);
}

/* As many whole rows as there are; what is left begins at *from. */
static uint64_t hash_rows(uint64_t hash, const char **from, size_t *count)
{
    uint64_t lanes[LANES], words[LANES];
    for (unsigned i = 0; i < LANES; i++)
        lanes[i] = random_key(hash, i);
    for (; *count >= ROW; *count -= ROW, *from += ROW) {
        memcpy(words, *from, ROW);
        for (unsigned i = 0; i < LANES; i++)
            lanes[i] = lane_mix(lanes[i], words[i]);
    }
    for (unsigned i = 0; i < LANES; i++)
        hash = random_key(hash, lanes[i]);
    return hash;
}

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count)
{
    const char *from = bytes;
    uint64_t word;
    if (count >= LONG)
        hash = hash_rows(hash, &from, &count);
    for (; count >= sizeof word; count -= sizeof word, from += sizeof word) {
        memcpy(&word, from, sizeof word);
        hash = random_mix(hash ^ random_mix(word));
    }
    word = 0;
    if (count)
        memcpy(&word, from, count);
    return random_key(random_key(hash, word), count);
}

uint64_t hash_numbers(uint64_t hash, const double *numbers, size_t count)
{
    return hash_bytes(hash, numbers, count * sizeof *numbers);
}

uint64_t hash_text(uint64_t hash, const char *text)
{
    return text ? hash_bytes(hash, text, strlen(text)) : random_mix(hash);
}

static uint64_t hash_field(uint64_t hash, enum field_kind kind, const void *at)
{
    const struct terms *terms = at;
    const struct points *points = at;
    switch (kind) {
    case FIELD_FLOAT:
        return hash_numbers(hash, at, 1);
    case FIELD_INTEGER:
    case FIELD_CHOICE:
        return hash_bytes(hash, at, sizeof(int));
    case FIELD_BOOL:
    case FIELD_FLAG:
        return random_key(hash, *(const bool *)at);
    case FIELD_VECTOR2:
    case FIELD_PAIR:
        return hash_numbers(hash, at, 2);
    case FIELD_VECTOR:
    case FIELD_RGB:
        return hash_numbers(hash, at, 3);
    case FIELD_VECTOR5:
    case FIELD_COLOUR:
        return hash_numbers(hash, at, 5);
    case FIELD_TERMS:
        return hash_numbers(hash, terms->values, terms->count);
    case FIELD_NAME:
        return hash_text(hash, *(const char *const *)at);
    case FIELD_POINTS:
    case FIELD_POINTS2:
        return hash_bytes(hash, points->items,
                          points->count * sizeof *points->items);
    }
    return hash;
}

_Static_assert(sizeof(vec3) == 3 * sizeof(double) &&
                   sizeof(rgb) == 3 * sizeof(double) &&
                   sizeof(colour) == 5 * sizeof(double),
               "vectors and colours are rows of numbers");

uint64_t hash_fields(uint64_t hash, const struct field *table,
                     const void *values)
{
    for (; table && table->name; table++)
        hash =
            hash_field(hash, table->kind, (const char *)values + table->offset);
    return hash;
}

uint64_t hash_narrow(uint64_t hash, const struct field *const *tables,
                     const void *values)
{
    double row[HASH_ROW];
    size_t count = 0;
    for (; *tables; tables++)
        count += field_numbers(*tables, values, FIELDS_NARROW, row + count);
    return hash_numbers(hash, row, count);
}

uint64_t hash_wide(uint64_t hash, const struct field *table, const void *values)
{
    double row[FIELD_WIDEST];
    for (; table->name; table++) {
        const struct field only[] = { *table, { NULL } };
        size_t count = field_numbers(only, values, FIELDS_WIDE, row);
        if (count)
            hash = hash_numbers(hash, row, count);
    }
    return hash;
}

uint64_t hash_tables(uint64_t hash, const struct field *const *tables,
                     const void *values)
{
    hash = hash_narrow(hash, tables, values);
    for (; *tables; tables++)
        hash = hash_wide(hash, *tables, values);
    return hash;
}
