/* Places that lamps light: see lit_cells.h. */
#include "lightmesh/lit_cells.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/side.h"
#include "lightmesh/tuning.h"

/* Those that bring most first. */
static int cell_lighter(const void *a, const void *b)
{
    const struct hit_cell *x = a, *y = b;
    return hit_cell_order(x->lamps, y->lamps, x, y);
}

/* Those that bring most; returns their share of all. */
static double lit_choose(struct bright *lit, struct hit_cell *cells,
                         size_t joined, double side)
{
    double total = 0, taken = 0;
    for (size_t i = 0; i < joined; i++)
        total += cells[i].lamps;
    qsort(cells, joined, sizeof *cells, cell_lighter);
    double rest = joined > BRIGHT_MOST ? cells[BRIGHT_MOST].lamps : 0;
    rest = fmax(rest, bright_least * total);
    lit->count = 0;
    lit->radius = side * bright_round;
    for (size_t i = 0; i < joined && lit->count < BRIGHT_MOST; i++) {
        const struct hit_cell *cell = &cells[i];
        double worth = bright_beyond(cell->lamps, rest);
        if (!(worth > 0))
            continue;
        lit->at[lit->count++] =
            (struct bright_disc){ hit_cell_centre(cell, side),
                                  side_normal(cell->facing), worth,
                                  cell->lamps / total };
        taken += cell->lamps;
    }
    return taken / total;
}

/* Returns how many of the hits are lit. */
static size_t hits_lit(struct bright_hit *lit, const struct bright_hit *hits,
                       size_t count)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
        if (hits[i].distance < HUGE_VAL && hits[i].lamps > 0)
            lit[n++] = hits[i];
    return n;
}

struct bright lit_cells_of(const struct bright_hit *hits, size_t count)
{
    struct bright lit = { .count = 0 };
    struct bright_hit *met = memory_new((count + 1) * sizeof *met);
    size_t n = hits_lit(met, hits, count);
    struct hit_room room = hit_room_of(met, n);
    double side = hit_room_cell(&room), taken = 0;
    if (side > 0) {
        struct hit_cell *cells = memory_new(n * sizeof *cells);
        for (int i = 0; i < LIT_SIDES && taken < lit_taken; i++, side *= 2) {
            size_t joined = hit_cells_join(cells, met, n, NULL, side);
            taken = lit_choose(&lit, cells, joined, side);
        }
        memory_free(cells);
    }
    memory_free(met);
    return lit;
}
