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
 * corners near enough to serve: all of its own or, if it is clipped, what
 * stands for them, whose weights are put into *weight, which has those of the
 * grid's. */
enum corner_hold { CELL_BENT, CELL_FAR, CELL_HOLDS, CELL_CLIPPED };

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

/* How far corners that differ so much are enough for those between them, 0 to
 * 1: those that are nearly so count in part, or all of their cell would change
 * at once where light moves. */
double shares_evenness(double differ);

/* Whether what a flat cell says at its corners holds between them, as they
 * differ little or nothing stands there. */
bool corner_cell_whole(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like);

/* Whether all corners are there and see each other: then nothing stands between
 * them and a place in their midst. */
bool corner_cell_clear(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like);

#endif
