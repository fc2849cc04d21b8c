/* A hash table by address with linear probing: see mesh_table.h. */
#include "world/mesh_table.h"

#include "base/random.h"

static struct mesh_entry *find(const struct mesh_table *table,
                               const struct mesh *mesh)
{
    size_t mask = table->capacity - 1;
    size_t at = (size_t)random_mix((uint64_t)(uintptr_t)mesh) & mask;
    while (table->entries[at].mesh && table->entries[at].mesh != mesh)
        at = (at + 1) & mask;
    return &table->entries[at];
}

static void grow(struct arena *arena, struct mesh_table *table)
{
    struct mesh_table old = *table;
    table->capacity = old.capacity ? old.capacity * 2 : 16;
    table->entries = ARENA_ARRAY(arena, struct mesh_entry, table->capacity);
    for (size_t i = 0; i < old.capacity; i++)
        if (old.entries[i].mesh)
            *find(table, old.entries[i].mesh) = old.entries[i];
}

struct mesh_entry *mesh_table_entry(struct arena *arena,
                                    struct mesh_table *table,
                                    const struct mesh *mesh)
{
    if ((table->count + 1) * 2 > table->capacity)
        grow(arena, table);
    struct mesh_entry *entry = find(table, mesh);
    if (!entry->mesh) {
        entry->mesh = mesh;
        table->count++;
    }
    return entry;
}
