/* The corners of a picture's surface grid (surface_grid.h), found when they are
 * asked for and kept: where they are, and the indirect light that those get
 * which serve. */
#ifndef LIGHTMESH_CORNER_STORE_H
#define LIGHTMESH_CORNER_STORE_H

#include "lightmesh/corner.h"
#include "lightmesh/surface_grid.h"

struct camera;
struct corner_store;

/* Of a picture that so many workers draw; mesh, camera and grid must outlive
 * it. Frees with corner_store_free. */
struct corner_store *corner_store_new(const struct indirect_mesh *mesh,
                                      const struct camera *camera,
                                      const struct surface_grid *grid,
                                      unsigned threads);
void corner_store_free(struct corner_store *store);

/* The corners around a place. */
struct corner_cell {
    struct grid_cell name;
    int coarser; /* as they are asked (point_mesh_worth) */
    bool used;
    signed char clear; /* corner_store_clear: -1 no, 1 yes, 0 not asked yet */
    const struct corner *corner[GRID_CORNERS]; /* NULL: not asked yet, or not
                                                * kept */
    const struct corner_light *light[GRID_CORNERS]; /* likewise */
    /* Whether all corners are on one plane (corner_cell_holds): -1 no, 1 yes, 0
     * not asked yet; if so where it is, and, once known, what they say. */
    signed char flat;
    bool told;
    vec3 at[GRID_CORNERS], side;
    double thick;  /* how far from the plane a place is on it, units */
    double reach2; /* square of how far all corners may serve */
    struct indirect_share share[GRID_CORNERS];
    double differ; /* by how much, of the largest of them */
};

/* The cell of that name: the worker keeps the last that it came by, as
 * neighbouring pixels have the same; or else `own` is made to be it. */
struct corner_cell *corner_store_cell(const struct corner_store *store,
                                      const struct worker *worker,
                                      const struct grid_cell *name, int coarser,
                                      struct corner_cell *own);

/* Corner `i`, for receivers that are seen as this one is: not `met` if no
 * surface is there that the camera sees. */
const struct corner *corner_store_corner(const struct corner_store *store,
                                         struct worker *worker,
                                         struct corner_cell *cell, int i,
                                         const struct receiver *like);

/* What it gets; it must be met. */
const struct corner_light *corner_store_light(const struct corner_store *store,
                                              struct worker *worker,
                                              struct corner_cell *cell, int i,
                                              const struct receiver *like);

/* Whether all corners of the cell are on the receiver's plane, and near enough
 * to serve it. */
enum corner_hold { CELL_BENT, CELL_FAR, CELL_HOLDS };

enum corner_hold corner_cell_holds(const struct corner_store *store,
                                   struct worker *worker,
                                   struct corner_cell *cell,
                                   const struct receiver *receiver);

/* Sets what the corners of a cell say, which have all been met, and by how much
 * they differ. */
void corner_cell_ask(const struct corner_store *store, struct worker *worker,
                     struct corner_cell *cell, const struct receiver *like);

/* By how much two of so many shares differ, as a part of the larger one. */
double shares_differ(const struct indirect_share *const *shares, int count);

/* Whether all corners are there and see each other: then nothing stands between
 * them and a place in their midst. */
bool corner_store_clear(const struct corner_store *store, struct worker *worker,
                        struct corner_cell *cell, const struct receiver *like);

#endif
