/* A record's place is its key's (table_index.h); it is won by compare-and-swap
 * of its number, and handed over by a release store of it. Records are in
 * blocks, which are made when they are first wanted. See table.h. */
#include "lightmesh/table.h"

#include <stdlib.h>
#include <string.h>

#include "base/map.h"
#include "base/memory.h"
#include "lightmesh/table_index.h"

enum { BLOCK_RECORDS = 256 };

/* Of a record's number, from 1; it is claimed until it is published. */
static const uint32_t number_none = 0, number_claimed = UINT32_C(1) << 31;

/* The keys of a table, or of the two that stand beside each other. */
struct table_keys {
    struct table_index *index;
    int columns; /* that are left */
};

/* BLOCK_RECORDS records. */
struct table_block {
    void *_Atomic records; /* NULL: none was wanted yet */
};

/* Before each record. */
struct table_head {
    struct table_place *place;
};

/* Records of a file (table_share): where each is, found by its key. */
struct table_shared {
    struct map *map;
    const char *entries;
    size_t count, stride;
    uint32_t *numbers; /* from 1; 0: free */
    size_t mask;
};

struct table {
    struct table_shared shared;
    struct table_keys *keys;
    int column;
    struct table_block *blocks;
    size_t record_size, stride, capacity;
    atomic_size_t used;
};

static size_t table_blocks(const struct table *table)
{
    return table->capacity / BLOCK_RECORDS + 1;
}

/* A table without keys. */
static struct table *table_column(size_t record_size, size_t bytes)
{
    struct table *table = memory_new(sizeof *table);
    table->record_size = record_size;
    table->stride = (sizeof(struct table_head) + record_size + 7) & ~(size_t)7;
    table->capacity =
        bytes / (table->stride + 2 * sizeof(struct table_place)) + 1;
    if (table->capacity >= number_claimed)
        table->capacity = number_claimed - 1;
    table->blocks = memory_new(table_blocks(table) * sizeof *table->blocks);
    return table;
}

static struct table_keys *keys_new(size_t capacity)
{
    struct table_keys *keys = memory_new(sizeof *keys);
    keys->index = table_index_new(capacity);
    return keys;
}

static void table_found_by(struct table *table, struct table_keys *keys)
{
    table->keys = keys;
    table->column = keys->columns++;
}

struct table *table_new(size_t record_size, size_t bytes)
{
    struct table *table = table_column(record_size, bytes);
    table_found_by(table, keys_new(table->capacity));
    return table;
}

struct table *table_new_beside(struct table **other, size_t record_size,
                               size_t bytes, size_t other_size,
                               size_t other_bytes)
{
    struct table *table = table_column(record_size, bytes);
    *other = table_column(other_size, other_bytes);
    size_t most = table->capacity > (*other)->capacity ? table->capacity
                                                       : (*other)->capacity;
    struct table_keys *keys = keys_new(most);
    table_found_by(table, keys);
    table_found_by(*other, keys);
    return table;
}

void table_free(struct table *table)
{
    if (!table)
        return;
    map_release(table->shared.map);
    memory_free(table->shared.numbers);
    if (--table->keys->columns == 0) {
        table_index_free(table->keys->index);
        memory_free(table->keys);
    }
    for (size_t i = 0; i < table_blocks(table); i++)
        memory_free(atomic_load(&table->blocks[i].records));
    memory_free(table->blocks);
    memory_free(table);
}

static uint64_t shared_key(const struct table_shared *shared, size_t number)
{
    uint64_t key;
    memcpy(&key, shared->entries + (number - 1) * shared->stride, sizeof key);
    return key;
}

static const void *shared_record(const struct table_shared *shared,
                                 size_t number)
{
    return shared->entries + (number - 1) * shared->stride + sizeof(uint64_t);
}

bool table_share(struct table *table, struct map *map, const void *entries,
                 size_t count, uint64_t (*hash)(uint64_t key))
{
    struct table_shared *shared = &table->shared;
    size_t places = 64;
    if (shared->map || table->record_size % 8 != 0 || count >= UINT32_MAX ||
        (uintptr_t)entries % 8 != 0)
        return false;
    while (places < 2 * count)
        places *= 2;
    map_hold(map);
    *shared = (struct table_shared){
        .map = map,
        .entries = entries,
        .count = count,
        .stride = sizeof(uint64_t) + table->record_size,
        .numbers = memory_new(places * sizeof *shared->numbers),
        .mask = places - 1,
    };
    for (size_t number = 1; number <= count; number++) {
        size_t place = hash(shared_key(shared, number)) & shared->mask;
        while (shared->numbers[place])
            place = (place + 1) & shared->mask;
        shared->numbers[place] = (uint32_t)number;
    }
    return true;
}

static const void *shared_find(const struct table_shared *shared, uint64_t key,
                               uint64_t hash)
{
    if (!shared->count)
        return NULL;
    size_t place = hash & shared->mask;
    for (; shared->numbers[place]; place = (place + 1) & shared->mask)
        if (shared_key(shared, shared->numbers[place]) == key)
            return shared_record(shared, shared->numbers[place]);
    return NULL;
}

/* NULL: its block was not wanted yet. */
static struct table_head *table_head(const struct table *table, size_t number)
{
    size_t from = (number - 1) / BLOCK_RECORDS;
    char *block = atomic_load_explicit(&table->blocks[from].records,
                                       memory_order_acquire);
    if (!block)
        return NULL;
    return (struct table_head *)(block +
                                 (number - 1) % BLOCK_RECORDS * table->stride);
}

static struct table_head *table_head_new(struct table *table, size_t number)
{
    made_once(&table->blocks[(number - 1) / BLOCK_RECORDS].records,
              BLOCK_RECORDS * table->stride);
    return table_head(table, number);
}

static bool table_is_full(struct table *table)
{
    return atomic_load(&table->used) >= table->capacity;
}

/* A new record at this place, which is the key's, unless another thread was
 * quicker. */
static enum table_state table_claim(struct table *table,
                                    struct table_place *place, void **record)
{
    uint32_t none = number_none;
    _Atomic uint32_t *claimed = &place->number[table->column];
    if (table_is_full(table) ||
        !atomic_compare_exchange_strong(claimed, &none, number_claimed))
        return TABLE_NONE;
    size_t number = atomic_fetch_add(&table->used, 1) + 1;
    if (number > table->capacity) {
        atomic_fetch_sub(&table->used, 1);
        atomic_store(claimed, number_none);
        return TABLE_NONE;
    }
    struct table_head *head = table_head_new(table, number);
    head->place = place;
    atomic_store(claimed, number_claimed | (uint32_t)number);
    *record = head + 1;
    return TABLE_MINE;
}

enum table_state table_find(struct table *table, uint64_t key, uint64_t hash,
                            void **record)
{
    const void *known = shared_find(&table->shared, key, hash);
    if (known) {
        *record = (void *)(uintptr_t)known;
        return TABLE_READY;
    }
    struct table_place *place =
        table_index_find(table->keys->index, key, hash, table_is_full(table));
    if (!place)
        return TABLE_NONE;
    uint32_t number = atomic_load_explicit(&place->number[table->column],
                                           memory_order_acquire);
    if (number == number_none)
        return table_claim(table, place, record);
    if (number & number_claimed)
        return TABLE_NONE;
    *record = table_head(table, number) + 1;
    return TABLE_READY;
}

void table_publish(struct table *table, void *record)
{
    struct table_head *head = (struct table_head *)record - 1;
    _Atomic uint32_t *claimed = &head->place->number[table->column];
    uint32_t number = atomic_load(claimed) & ~number_claimed;
    atomic_store_explicit(claimed, number, memory_order_release);
}

void table_insert(struct table *table, uint64_t key, uint64_t hash,
                  const void *record)
{
    void *own;
    if (table_find(table, key, hash, &own) != TABLE_MINE)
        return;
    memcpy(own, record, table->record_size);
    table_publish(table, own);
}

static int entry_order(const void *a, const void *b)
{
    const struct table_entry *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

size_t table_entries(const struct table *table, struct table_entry *entries)
{
    size_t count = 0;
    const struct table_shared *shared = &table->shared;
    for (size_t n = 1; n <= shared->count; n++)
        entries[count++] = (struct table_entry){ shared_key(shared, n),
                                                 shared_record(shared, n) };
    const struct table_place *place;
    for (size_t i = 0; (place = table_index_at(table->keys->index, i)); i++) {
        uint32_t number = atomic_load(&place->number[table->column]);
        if (number != number_none && !(number & number_claimed))
            entries[count++] =
                (struct table_entry){ atomic_load(&place->key),
                                      table_head(table, number) + 1 };
    }
    qsort(entries, count, sizeof *entries, entry_order);
    return count;
}

size_t table_record_size(const struct table *table)
{
    return table->record_size;
}

const void *table_at(const struct table *table, size_t number, uint64_t *key)
{
    const struct table_shared *shared = &table->shared;
    if (number < shared->count) {
        *key = shared_key(shared, number + 1);
        return shared_record(shared, number + 1);
    }
    number -= shared->count;
    const struct table_head *head = table_head(table, number + 1);
    if (!head || !head->place ||
        atomic_load(&head->place->number[table->column]) != number + 1)
        return NULL;
    *key = atomic_load(&head->place->key);
    return head + 1;
}

size_t table_count(const struct table *table)
{
    return table->shared.count + atomic_load(&table->used);
}

size_t table_capacity(const struct table *table)
{
    return table->capacity;
}

size_t table_bytes(const struct table *table)
{
    return table_index_bytes(table->keys->index) /
               (size_t)table->keys->columns +
           atomic_load(&table->used) * table->stride +
           (table->shared.map ? table->shared.mask + 1 : 0) *
               sizeof *table->shared.numbers;
}
