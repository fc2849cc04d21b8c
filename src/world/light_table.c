/* A hash table with linear probing: see light_table.h. */
#include "world/light_table.h"

#include <math.h>
#include <string.h>

#include "base/hash.h"

/* Powers of 2 to which places are rounded: a quarter of a millionth of a unit,
 * of which no shadow tells, or as much of what is far from 0 as rounding may
 * have moved. */
enum { PLACE_STEP = -22, PLACE_BITS = 36 };

static double place_rounded(double x)
{
    int exponent;
    frexp(x, &exponent);
    exponent -= PLACE_BITS;
    double step = ldexp(1, exponent > PLACE_STEP ? exponent : PLACE_STEP);
    return rint(x / step) * step + 0.0; /* -0 is 0 */
}

static vec3 vec3_rounded(vec3 v)
{
    return vec3_make(place_rounded(v.x), place_rounded(v.y),
                     place_rounded(v.z));
}

/* All that is said of a light but its colour, with places rounded. */
static void light_said_nearly(const struct light *light,
                              double said[LIGHT_SAID_MOST])
{
    struct light nearly = *light;
    nearly.location = vec3_rounded(light->location);
    nearly.point_at = vec3_rounded(light->point_at);
    nearly.axis1 = vec3_rounded(light->axis1);
    nearly.axis2 = vec3_rounded(light->axis2);
    light_said(&nearly, said);
}

/* What light_said_nearly says. */
struct light_entry {
    bool used;
    size_t number;
    double said[LIGHT_SAID_MOST];
};

static struct light_entry *entry_of(const struct light_table *table,
                                    const double said[LIGHT_SAID_MOST])
{
    size_t mask = table->capacity - 1;
    size_t at = (size_t)hash_numbers(0, said, LIGHT_SAID_MOST) & mask;
    while (table->entries[at].used && memcmp(table->entries[at].said, said,
                                             sizeof(double) * LIGHT_SAID_MOST))
        at = (at + 1) & mask;
    return &table->entries[at];
}

static void table_grow(struct light_table *table, struct arena *arena)
{
    struct light_table old = *table;
    table->capacity = old.capacity ? 2 * old.capacity : 16;
    table->entries = ARENA_ARRAY(arena, struct light_entry, table->capacity);
    for (size_t i = 0; i < old.capacity; i++)
        if (old.entries[i].used)
            *entry_of(table, old.entries[i].said) = old.entries[i];
}

size_t light_table_number(struct light_table *table, struct arena *arena,
                          const struct light *light, size_t number)
{
    double said[LIGHT_SAID_MOST] = { 0 };
    if (2 * table->count >= table->capacity)
        table_grow(table, arena);
    light_said_nearly(light, said);
    struct light_entry *entry = entry_of(table, said);
    if (entry->used)
        return entry->number;
    entry->used = true;
    entry->number = number;
    memcpy(entry->said, said, sizeof said);
    table->count++;
    return number;
}
