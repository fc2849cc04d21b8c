/* What the rays of a survey met, by the cells of a lattice in the world, which
 * stays where it is when the camera moves. What faces another way is in another
 * cell. */
#ifndef LIGHTMESH_HIT_CELLS_H
#define LIGHTMESH_HIT_CELLS_H

#include <stddef.h>
#include <stdint.h>

#include "base/vec.h"

/* What one ray found. */
struct bright_hit {
    vec3 origin, direction; /* of the ray; unit */
    vec3 normal;            /* of what it met, against the ray; unit */
    double distance;        /* HUGE_VAL: it left the scene */
    double light;           /* of the picture, as are */
    double lamps;           /* what of it lamps give the surface that was met */
};

/* Where it met something. */
vec3 bright_hit_place(const struct bright_hit *hit);

/* The box that most hits are in: a chamber. */
struct hit_room {
    double low[3], high[3]; /* units; of no hits 0 */
};
struct hit_room hit_room_of(const struct bright_hit *hits, size_t count);
double hit_room_size(const struct hit_room *room); /* its longest edge */

/* The side of cells of which it is some ten long (tuning.h); 0: it has no size.
 */
double hit_room_cell(const struct hit_room *room);

/* The hits in one cell. */
struct hit_cell {
    int at[3], facing; /* side.h */
    int count;
    double along;        /* the axis that it faces; their sum, as are */
    double light, lamps; /* those of the hits */
};

/* Joins so many hits to cells of that side, in an order of places; returns how
 * many there are into *cells, which has room for as many as there are hits. Of
 * hits outside of the room (NULL: all are as they are) counts where their rays
 * leave it. */
size_t hit_cells_join(struct hit_cell *cells, const struct bright_hit *hits,
                      size_t count, const struct hit_room *room, double side);

/* For qsort: a before b if x is more than y, or in the order of places where
 * they are alike. */
int hit_cell_order(double x, double y, const struct hit_cell *a,
                   const struct hit_cell *b);

/* In the plane of what is in the cell. */
vec3 hit_cell_centre(const struct hit_cell *cell, double side);

/* The middle of the cell of that side that a place is in which faces so
 * (side.h); and its name, never 0. */
vec3 cell_middle(vec3 place, int facing, double side);
uint64_t cell_key(vec3 place, int facing, double side);

#endif
