/* The corners of a picture's surface grid (surface_grid.h), found when they are
 * asked for and kept: where they are, and the indirect light that those get
 * which serve. */
#ifndef LIGHTMESH_CORNER_STORE_H
#define LIGHTMESH_CORNER_STORE_H

#include "lightmesh/corner.h"
#include "lightmesh/surface_grid.h"

struct camera;
struct cells;
struct table;

/* Its grid and mesh are for those who ask, the rest is its own. */
struct corner_store {
    const struct indirect_mesh *mesh;
    const struct camera *camera;
    const struct surface_grid *grid;
    struct table *corners; /* where they are, and beside, by the same keys, */
    struct table *lights;  /* what those know that served */
    unsigned threads;
    struct cells *cells; /* of each worker */
};

/* Of a picture that so many workers draw; mesh, camera and grid must outlive
 * it. All who ask it are far sides, whose corners are found on the sides that
 * are seen, or none is. Frees with corner_store_free. */
struct corner_store *corner_store_new(const struct indirect_mesh *mesh,
                                      const struct camera *camera,
                                      const struct surface_grid *grid,
                                      unsigned threads);
void corner_store_free(struct corner_store *store);

/* What stands for a corner of a cell that is flat (corner_cell.h): */
struct cell_place {
    int way;  /* 0: the grid's own corner; else another place on its surface,
               * named by how it was found (grid_corner_key), */
    int like; /* or, unless below 0, what that one of the others says */
    struct corner corner;
};

/* The corners around a place. */
struct corner_cell {
    struct grid_cell name;
    int coarser; /* as they are asked (point_mesh_worth) */
    bool used;
    signed char clear; /* corner_store_clear: -1 no, 1 yes, 0 not asked yet */
    /* Whether it is flat (corner_cell_holds): -1 no, 1 yes, 0 not asked yet; if
     * so where it is, and, once known, what is said there. */
    signed char flat;
    bool clipped; /* not all are the grid's own corners: */
    bool reaches; /* all may serve wherever it is */
    bool told;
    struct corner plane; /* a corner that is on it */
    double thick;        /* how far from the plane a place is on it, units */
    double differ;       /* by how much, of the largest of them */
    struct indirect_share share[GRID_CORNERS];
    double reach2; /* square of how far all corners may serve */
    struct cell_place place[GRID_CORNERS];
    double end[2][2][2]; /* along both axes, in the first row and the second,
                          * where it begins and ends, steps */
    const struct corner *corner[GRID_CORNERS]; /* NULL: not asked yet, or not
                                                * kept */
    const struct corner_light *light[GRID_CORNERS]; /* likewise */
};

/* The cell of that name: the worker keeps the last that it came by, as
 * neighbouring pixels have the same; or else `own` is made to be it. */
struct corner_cell *corner_store_cell(const struct corner_store *store,
                                      const struct worker *worker,
                                      const struct grid_cell *name, int coarser,
                                      struct corner_cell *own);

/* The one of that level that the worker came by last, or NULL. */
struct corner_cell *corner_store_last(const struct corner_store *store,
                                      const struct worker *worker, int level);

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

/* What stands for corner `i` of a flat cell gets, unless it is like another. */
struct indirect_share corner_store_share(const struct corner_store *store,
                                         struct worker *worker,
                                         struct corner_cell *cell, int i,
                                         const struct receiver *like);

#endif
