/* Growing arrays in an arena: see array.h. */
#include "base/array.h"

void *array_grow(struct arena *arena, void *items, size_t count,
                 size_t *capacity, size_t item_size)
{
    size_t wanted = *capacity ? *capacity * 2 : 8;
    return array_reserve(arena, items, count, capacity, wanted, item_size);
}

void *array_reserve(struct arena *arena, void *items, size_t count,
                    size_t *capacity, size_t wanted, size_t item_size)
{
    if (wanted <= *capacity)
        return items;
    void *grown = arena_alloc(arena, wanted * item_size);
    if (count)
        memcpy(grown, items, count * item_size);
    *capacity = wanted;
    return grown;
}
