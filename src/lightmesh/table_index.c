/* The keys of tables: see table_index.h. */
#include "lightmesh/table_index.h"

#include "base/memory.h"

enum {
    LEVELS_MAX = 12,
    LEVEL_LEAST = 8192, /* places of the first level at least; each further */
    LEVEL_BITS = 3,     /* one has so many more, a power of two */
    LEVEL_PROBES = 8,   /* places of a level where a key may be, */
    PROBES_MAX = 512,   /* and of the last */
};

struct table_index {
    void *_Atomic levels[LEVELS_MAX]; /* places; NULL: not wanted yet */
    int count;                        /* of them */
    size_t places;                    /* of the last, which has room for all */
};

/* `get` is memory_new or one of its kin. */
static void *got_once(void *_Atomic *made, size_t size, void *(*get)(size_t))
{
    void *known = atomic_load_explicit(made, memory_order_acquire);
    if (known)
        return known;
    void *own = get(size);
    if (atomic_compare_exchange_strong(made, &known, own))
        return own;
    memory_free(own);
    return known;
}

void *made_once(void *_Atomic *made, size_t size)
{
    return got_once(made, size, memory_new);
}

static size_t level_places(const struct table_index *index, int level)
{
    return index->places >> (LEVEL_BITS * (index->count - 1 - level));
}

struct table_index *table_index_new(size_t capacity)
{
    struct table_index *index = memory_new(sizeof *index);
    index->places = 64;
    while (index->places * 3 < capacity * 4)
        index->places *= 2;
    index->count = 1;
    while (index->count < LEVELS_MAX &&
           level_places(index, 0) >> LEVEL_BITS >= LEVEL_LEAST)
        index->count++;
    return index;
}

void table_index_free(struct table_index *index)
{
    for (int i = 0; i < index->count; i++)
        memory_free(atomic_load(&index->levels[i]));
    memory_free(index);
}

/* The key's place in a level, which it takes unless `known`; NULL: there is
 * none, and *end if it can't be further on. */
static struct table_place *level_find(struct table_index *index, int level,
                                      uint64_t key, uint64_t hash, bool known,
                                      bool *end)
{
    size_t mask = level_places(index, level) - 1;
    size_t probes = level + 1 < index->count ? LEVEL_PROBES : PROBES_MAX;
    /* A further level may get little of what the first had no room for. */
    struct table_place *places =
        got_once(&index->levels[level], (mask + 1) * sizeof *places,
                 level > 0 ? memory_new_lazy : memory_new);
    for (size_t i = 0; i < probes; i++) {
        struct table_place *place = &places[(hash + i) & mask];
        uint64_t found =
            atomic_load_explicit(&place->key, memory_order_relaxed);
        *end = found == 0 && known;
        if (*end)
            return NULL;
        if (found == 0)
            atomic_compare_exchange_strong(&place->key, &found, key);
        if (found == 0 || found == key)
            return place;
    }
    return NULL;
}

struct table_place *table_index_find(struct table_index *index, uint64_t key,
                                     uint64_t hash, bool known)
{
    struct table_place *place = NULL;
    bool end = false;
    for (int level = 0; !place && !end && level < index->count; level++)
        place = level_find(index, level, key, hash, known, &end);
    return place;
}

const struct table_place *table_index_at(const struct table_index *index,
                                         size_t number)
{
    for (int level = 0; level < index->count; level++) {
        const struct table_place *places = atomic_load(&index->levels[level]);
        size_t count = places ? level_places(index, level) : 0;
        if (number < count)
            return &places[number];
        number -= count;
    }
    return NULL;
}

size_t table_index_bytes(const struct table_index *index)
{
    size_t places = 0;
    for (int level = 0; level < index->count; level++)
        places +=
            atomic_load(&index->levels[level]) ? level_places(index, level) : 0;
    return places * sizeof(struct table_place);
}
