/* Cells of a picture's surface grid that are flat: their corners say once for
 * all pixels between them what they get. A cell at the edge of its surface
 * lacks corners. Where another surface ends it, as a wall does a floor, it is
 * clipped there: what light does in the last cell before a wall is what shows
 * that they meet. Where something hides a corner from the camera alone it still
 * serves; where there is nothing more, the ones beside it say what it would. */
#ifndef LIGHTMESH_CORNER_CELL_H
#define LIGHTMESH_CORNER_CELL_H

#include "lightmesh/corner_store.h"

/* Whether the cell is flat, on the receiver's plane and about it, and its
 * corners near enough to serve; if so *weight, which the grid's corners would
 * have, is made that of what stands for them. */
enum corner_hold { CELL_BENT, CELL_FAR, CELL_HOLDS };

enum corner_hold corner_cell_holds(const struct corner_store *store,
                                   struct worker *worker,
                                   struct corner_cell *cell,
                                   const struct receiver *receiver,
                                   double weight[GRID_CORNERS]);

/* Sets what a flat cell says at its corners, or another whose corners have all
 * been met, and by how much they differ. */
void corner_cell_ask(const struct corner_store *store, struct worker *worker,
                     struct corner_cell *cell, const struct receiver *like);

/* By how much two of so many shares differ, as a part of the larger one. */
double shares_differ(const struct indirect_share *const *shares, int count);

/* Whether all corners are there and see each other: then nothing stands between
 * them and a place in their midst. */
bool corner_cell_clear(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like);

#endif
