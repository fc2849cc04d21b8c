/* Where the keys of a table are (table.h): open addressing with linear probing;
 * a place is won by compare-and-swap of its key.
 *
 * Memory costs when it is first touched, on virtual machines more than what is
 * then done with it: an index begins small. It has levels, each larger than the
 * one before; a key is looked for at a few places of each before it goes to the
 * next, and since no place is ever given up, all threads find it at the same.
 */
#ifndef LIGHTMESH_TABLE_INDEX_H
#define LIGHTMESH_TABLE_INDEX_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TABLE_COLUMNS = 2 };

struct table_place {
    _Atomic uint64_t key; /* 0: free */
    _Atomic uint32_t number[TABLE_COLUMNS];
};

struct table_index;

/* With room for so many keys. Frees with table_index_free. */
struct table_index *table_index_new(size_t capacity);
void table_index_free(struct table_index *index);

/* The key's place, which it takes unless `known`; NULL: there is none. `key` is
 * not 0. */
struct table_place *table_index_find(struct table_index *index, uint64_t key,
                                     uint64_t hash, bool known);

/* The places by number, from 0 on; places that were not wanted yet are left
 * out. NULL past the end. */
const struct table_place *table_index_at(const struct table_index *index,
                                         size_t number);

size_t table_index_bytes(const struct table_index *index);

/* Memory that several threads may want at once: the first makes it, zeroed, to
 * be freed by memory_free. */
void *made_once(void *_Atomic *made, size_t size);

#endif
