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
    size_t old = *capacity;
    *capacity = wanted;
    if (old && arena_resize(arena, items, old * item_size, wanted * item_size))
        return items;
    void *grown = arena_alloc(arena, wanted * item_size);
    if (count)
        memcpy(grown, items, count * item_size);
    return grown;
}

void array_fit(struct arena *arena, void *items, size_t count, size_t *capacity,
               size_t item_size)
{
    if (arena_resize(arena, items, *capacity * item_size, count * item_size))
        *capacity = count;
}
