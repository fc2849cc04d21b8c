/* The longest tiles first: see tile_order.h. */
#include "render/tile_order.h"

#include <stdlib.h>

#include "base/memory.h"

struct timed_tile {
    double seconds;
    size_t tile;
};

void tile_order_start(struct tile_order *order, size_t across, size_t count)
{
    order->seconds = memory_new(count * sizeof *order->seconds);
    order->across = across;
}

void tile_order_end(struct tile_order *order)
{
    memory_free(order->seconds);
    memory_free(order->tiles);
    *order = (struct tile_order){ .tiles = NULL };
}

void tile_order_note(struct tile_order *order, size_t tile, double seconds)
{
    if (order->seconds && !order->tiles)
        order->seconds[tile] = seconds;
}

/* Longer ones before; of the same length, as they lie. */
static int by_length(const void *left, const void *right)
{
    const struct timed_tile *a = left, *b = right;
    if (a->seconds != b->seconds)
        return a->seconds < b->seconds ? 1 : -1;
    return a->tile > b->tile ? 1 : -1;
}

void tile_order_sort(struct tile_order *order, size_t across, size_t count)
{
    struct timed_tile *all = memory_new(count * sizeof *all);
    for (size_t i = 0; i < count; i++) {
        size_t before = i / across * order->across + i % across;
        all[i] = (struct timed_tile){ order->seconds[before], i };
    }
    qsort(all, count, sizeof *all, by_length);
    order->tiles = memory_new(count * sizeof *order->tiles);
    for (size_t i = 0; i < count; i++)
        order->tiles[i] = all[i].tile;
    memory_free(all);
}
