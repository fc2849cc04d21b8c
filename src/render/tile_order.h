/* In which order threads take the tiles of a pass: first those that took
 * longest in the pass before, so that none of them is begun when the others
 * have nothing left to do (longest processing time first: Graham, "Bounds on
 * multiprocessing timing anomalies", 1969). What the picture becomes does not
 * depend on it. */
#ifndef RENDER_TILE_ORDER_H
#define RENDER_TILE_ORDER_H

#include <stddef.h>

struct tile_order {
    double *seconds; /* of each tile of the pass before, in rows of `across` */
    size_t across;
    size_t *tiles; /* in their order; NULL: as they lie */
};

/* Before the pass that is timed; freed by tile_order_end. */
void tile_order_start(struct tile_order *order, size_t across, size_t count);
void tile_order_end(struct tile_order *order);

/* From any thread, each tile once. */
void tile_order_note(struct tile_order *order, size_t tile, double seconds);

/* Before the pass that is put in order: `count` tiles, in rows of `across` of
 * them, none of which is longer than those before. */
void tile_order_sort(struct tile_order *order, size_t across, size_t count);

/* The tile that is number `item` in the order. */
static inline size_t tile_order_at(const struct tile_order *order, size_t item)
{
    return order->tiles ? order->tiles[item] : item;
}

#endif
