/* A table of records of one size, found by key, that many threads fill at
 * once: a record is claimed by the first who wants it, computed, and then
 * published for good. Memory is bounded; when it is full, records that are not
 * in it are computed again each time, which changes time and not results. */
#ifndef LIGHTMESH_TABLE_H
#define LIGHTMESH_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct table;

enum table_state {
    TABLE_READY, /* *record may be read */
    TABLE_MINE,  /* *record is yours to fill; then call table_publish */
    TABLE_NONE,  /* another is at it, or no room: compute your own */
};

/* Room for about `bytes` in all; pages are taken from the system as they are
 * used. */
struct table *table_new(size_t record_size, size_t bytes);

/* Two that stand beside each other, *other being the second: one set of keys,
 * each of which may have a record in either. For keys that mostly have both. */
struct table *table_new_beside(struct table **other, size_t record_size,
                               size_t bytes, size_t other_size,
                               size_t other_bytes);
void table_free(struct table *table);

/* `key` is not 0; `hash` spreads keys, and may keep neighbours together. */
enum table_state table_find(struct table *table, uint64_t key, uint64_t hash,
                            void **record);
void table_publish(struct table *table, void *record);

/* A record that is already known. Without room for it nothing happens. */
void table_insert(struct table *table, uint64_t key, uint64_t hash,
                  const void *record);

/* Records that are known and lie elsewhere, in memory that is held for as long
 * as the table lasts: `count` times a key, and the record, on bounds of 8
 * bytes. They are neither copied nor changed, and take no room. False if
 * records of this size can't be had so. `hash` is as of table_find. */
struct map;
bool table_share(struct table *table, struct map *map, const void *entries,
                 size_t count, uint64_t (*hash)(uint64_t key));

/* All published records by increasing key, table_count of them at most, into
 * `entries`; how many. Not while others fill the table. */
struct table_entry {
    uint64_t key;
    const void *record;
};
size_t table_entries(const struct table *table, struct table_entry *entries);

/* Bytes of a record. */
size_t table_record_size(const struct table *table);

/* Published record `number`, from 0 to below table_count, and its key; NULL if
 * it isn't. Their order is chance. */
const void *table_at(const struct table *table, size_t number, uint64_t *key);

/* Records in use, how many fit, and the bytes touched that are no others'; of
 * two beside each other each has half of what both need. */
size_t table_count(const struct table *table);
size_t table_capacity(const struct table *table);
size_t table_bytes(const struct table *table);

#endif
