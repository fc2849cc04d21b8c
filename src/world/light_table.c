/* A hash table with linear probing: see light_table.h. */
#include "world/light_table.h"

#include <string.h>

#include "base/hash.h"

enum { LIGHT_NUMBERS = 37 };

/* All that is said of a light but its colour. */
struct light_entry {
    bool used;
    size_t number;
    double said[LIGHT_NUMBERS];
};

static void put_vector(double to[3], vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

/* A lamp that shines everywhere alike says nothing by where it points. */
static bool light_points(const struct light *light)
{
    return light->kind != LIGHT_POINT || light->parallel || light->area;
}

static void light_numbers(const struct light *light, double said[LIGHT_NUMBERS])
{
    const struct photon_flags *photons = &light->photons;
    const double plain[] = {
        light->kind,
        light->parallel,
        light->radius,
        light->falloff,
        light->tightness,
        light->fade_distance,
        light->fade_power,
        light->shadowless,
        light->no_media,
        light->media_attenuation,
        photons->refraction,
        photons->reflection,
        photons->target,
        photons->spacing,
        photons->unlit,
        photons->area,
        light->group,
        light->area,
        light->size1,
        light->size2,
        light->adaptive,
        light->circular,
        light->orient,
        light->jitter,
        light->area_illumination,
    };
    memset(said, 0, sizeof(double) * LIGHT_NUMBERS);
    put_vector(&said[0], light->location);
    if (light_points(light))
        put_vector(&said[3], light->point_at);
    if (light->area)
        put_vector(&said[6], light->axis1);
    if (light->area)
        put_vector(&said[9], light->axis2);
    memcpy(&said[12], plain, sizeof plain);
}

static struct light_entry *entry_of(const struct light_table *table,
                                    const double said[LIGHT_NUMBERS])
{
    size_t mask = table->capacity - 1;
    size_t at = (size_t)hash_numbers(0, said, LIGHT_NUMBERS) & mask;
    while (table->entries[at].used && memcmp(table->entries[at].said, said,
                                             sizeof(double) * LIGHT_NUMBERS))
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
    double said[LIGHT_NUMBERS];
    if (2 * table->count >= table->capacity)
        table_grow(table, arena);
    light_numbers(light, said);
    struct light_entry *entry = entry_of(table, said);
    if (entry->used)
        return entry->number;
    entry->used = true;
    entry->number = number;
    memcpy(entry->said, said, sizeof said);
    table->count++;
    return number;
}
