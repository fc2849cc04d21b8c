/* The hemispheres of mesh points looked at more closely where it pays: adaptive
 * supersampling (Whitted, An Improved Illumination Model for Shaded Display,
 * 1980), of directions instead of pixels. Each way of a mesh point stands for
 * the cell of the sphere that is nearest to it. Where what it brought is
 * another than what a way beside it did, an edge is between them, and how much
 * of each cell is on which side of it is found by the ways that the other parts
 * of the set have in the cell. Else walls would be blotched, and flicker where
 * something moves before what is bright. */
#ifndef LIGHTMESH_WAY_CELLS_H
#define LIGHTMESH_WAY_CELLS_H

#include <stdbool.h>

#include "lightmesh/gather_ways.h"

enum { WAY_CELLS_MOST = 2048 }; /* of a part */

/* Those of one part: */
struct part_cells {
    uint32_t *first; /* of each cell and after the last: where its ways, */
    uint32_t *ways; /* as gather_ways numbers them, begin, its own among them */
    uint32_t pairs; /* of cells that are side by side */
    uint32_t (*pair)[2];
};

struct way_cells {
    uint32_t count; /* of a part; 0: there are none */
    struct part_cells part[GATHER_PARTS];
};

/* Of the first `count` ways of each part; none if these are more than
 * WAY_CELLS_MOST or not kept. Frees with way_cells_free. */
struct way_cells way_cells_new(const struct gather_ways *ways, uint32_t count);
void way_cells_free(struct way_cells *cells);

/* Into edge[], for each cell of the part, whether it differs from one beside it
 * by more than `most`. brought[]: what each way brought; NAN: it was not sent.
 */
void way_cells_edges(const struct way_cells *cells, uint32_t part,
                     const double *brought, double most, bool *edge);

#endif
