/* The corners of a picture's surface grid (surface_grid.h) around one place
 * that serve it, and what they say together. */
#ifndef LIGHTMESH_CORNERS_H
#define LIGHTMESH_CORNERS_H

#include "lightmesh/corner_cell.h"

/* Who asks. */
struct corners_asker {
    const struct corner_store *store;
    struct worker *worker;
    const struct receiver *receiver;
};

struct corners {
    double grid[GRID_CORNERS];     /* weights of the cell's, */
    double weight[GRID_CORNERS];   /* and of those of a cell that holds */
    struct corner_cell *cell, own; /* own: where the worker keeps none; NULL:
                                    * there is none */
    enum corner_hold hold;
    int count;
    bool missing; /* another is on another surface */
    double sum;
    struct {
        int number; /* in the cell */
        double weight;
        const struct corner *corner;
        const struct corner_light *light;
    } at[GRID_CORNERS];
};

/* Finds the cell around a place on a level. Most pixels are on one plane with
 * all corners of their cell, which then says at once by how much they differ;
 * the rest of `corners` is set by corners_find. */
void corners_begin(struct corners *corners, const struct corners_asker *ask,
                   int level);

/* The cell's corners, whose light isn't asked yet. Leaves off at the first that
 * is on another surface if only all of them are wanted. */
void corners_find(struct corners *corners, const struct corners_asker *ask,
                  bool all);

/* Their light. */
void corners_ask(struct corners *corners, const struct corners_asker *ask);

/* By how much that differs; cells remember it for all of theirs. */
double corners_differ(const struct corners *corners,
                      const struct corners_asker *ask);

/* Leaves out what can't be seen from the place, where it matters: where corners
 * differ much something may stand between, or on one; where another surface is
 * near, a wall may stand between all corners and the place. */
void corners_look(struct corners *corners, const struct corners_asker *ask);

/* What they say; all must have been asked. */
struct indirect_share corners_light(const struct corners *corners,
                                    const struct corners_asker *ask);

/* What a cell says that holds. */
struct indirect_share corners_flat_share(const struct corners *corners);

#endif
