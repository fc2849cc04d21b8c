/* Places of surfaces that lamps light, in one cell (hit_cells.h), by a grid of
 * rays into it. */
#ifndef LIGHTMESH_VIRTUAL_SAMPLES_H
#define LIGHTMESH_VIRTUAL_SAMPLES_H

#include "base/worker.h"
#include "lightmesh/virtual_lights.h"

enum {
    VIRTUAL_LAYERS = 3,     /* of surfaces behind each other, at most */
    VIRTUAL_EDGE_MOST = 32, /* a power of two */
    VIRTUAL_SAMPLES_MOST =
        VIRTUAL_LAYERS * VIRTUAL_EDGE_MOST * VIRTUAL_EDGE_MOST,
};

/* With `edge` rays along each edge, a power of two up to VIRTUAL_EDGE_MOST.
 * Returns how many are lit into *found, along a curve, each with its area. */
size_t virtual_samples_of(const struct lamps *lamps, struct worker *worker,
                          const struct virtual_cell *cell, double side,
                          unsigned edge, struct virtual_light *found);

/* Of a light, its strongest part; lamps may be negative, in one colour or all.
 */
double virtual_light_amount(rgb light);

#endif
