/* Lights that differ in nothing but their colours, found by all the rest: in
 * one place, or so near to each other that no picture shows it, they are one
 * light, and its shadow is asked for once. */
#ifndef WORLD_LIGHT_TABLE_H
#define WORLD_LIGHT_TABLE_H

#include "base/arena.h"
#include "scene/light.h"

/* Begins zeroed. */
struct light_table {
    struct light_entry *entries;
    size_t count, capacity;
};

/* The number of a light that is in the table and like this one, or `number`,
 * under which it then is in it. */
size_t light_table_number(struct light_table *table, struct arena *arena,
                          const struct light *light, size_t number);

#endif
