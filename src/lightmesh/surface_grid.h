/* Grids on the surfaces of a scene, each level twice as coarse as the one
 * before: corners between which light that changes slowly is interpolated. They
 * are fixed to the world, so what interpolation gets wrong stays where it is
 * while the camera moves and is no flicker; which level a place uses follows
 * from how large a pixel is there.
 *
 * A corner is where a line along the axis that the surface faces most meets it
 * within one cell. It is named by its level, the axis, the way along it and
 * three integers, and is a function of its name alone. */
#ifndef LIGHTMESH_SURFACE_GRID_H
#define LIGHTMESH_SURFACE_GRID_H

#include "lightmesh/receiver.h"

struct camera;

enum { GRID_CORNERS = 4, GRID_LEVELS = 32 };

struct surface_grid {
    vec3 origin;
    double step[GRID_LEVELS];   /* from corner to corner, units, */
    double within[GRID_LEVELS]; /* and how often it is in a unit */
    /* How far apart corners are wanted of a surface that faces the camera, over
     * the step of level 0, there and with each unit of way. */
    double wanted, wanted_grows;
    bool central; /* all that the camera sees, also through panes, it sees from
                   */
    vec3 eye;
};

/* Corners so many pixels apart of a picture so many pixels wide and high, where
 * lengths are about `typical`: far larger and smaller steps are out of range.
 */
struct surface_grid surface_grid_new(const struct camera *camera,
                                     const int size[2], double apart,
                                     vec3 origin, double typical);

/* The level of a place that the camera sees, and how much of the next coarser
 * one is blended in: 0 but near the change from one to the other. */
int surface_grid_level(const struct surface_grid *grid,
                       const struct receiver *receiver, double *blend);

/* The corners around a place on one level, if its surface is flat. */
struct grid_cell {
    int level, axis;
    bool down; /* its surface faces the axis' negative end */
    int at[2]; /* of the first, along the axes after that axis; others are one
                * further along the first, the second and both */
    int slab[GRID_CORNERS]; /* cells along the axis */
    vec3 side;              /* what it faces */
};

/* And what each of them counts there; they sum to 1. False: that far from the
 * origin there are no names. */
bool surface_grid_cell(const struct surface_grid *grid,
                       const struct receiver *receiver, int level,
                       struct grid_cell *cell, double weight[GRID_CORNERS]);

/* Whether that is the cell of another place on the same plane, which faces what
 * the cell does: if so what corners count there. */
bool surface_grid_within(const struct surface_grid *grid,
                         const struct grid_cell *cell, vec3 point,
                         double weight[GRID_CORNERS]);

/* Whether they have the same corners. */
bool grid_cells_same(const struct grid_cell *a, const struct grid_cell *b);

/* The name of a corner as a number, never 0; `kind`, 0 to 3, and `way`, 0 to 8,
 * are the caller's. */
uint64_t grid_corner_key(const struct grid_cell *cell, int corner, int kind,
                         int way);

/* From corner to corner along the first or the second axis of the cell, on a
 * plane with that normal. */
vec3 grid_cell_along(const struct grid_cell *cell, vec3 side, int axis,
                     double step);

/* The line on which the corner is, and how long it is. */
struct ray grid_corner_line(const struct surface_grid *grid,
                            const struct grid_cell *cell, int corner,
                            double *length);

#endif
