/* Pavements of the plane by polyforms, tiles of some triangles, squares or
 * hexagons: what the pavement pattern looks up. */
#ifndef SCENE_PAVEMENT_H
#define SCENE_PAVEMENT_H

#include <stdbool.h>

enum { PAVEMENT_COUNT = 112 };

/* Which edges of a lattice of squares, or of triangles (a hexagon is six), are
 * borders of tiles: an octal digit for each point of a cell, row by row, is the
 * sum of 1 for the edge along x, 2 for that to the next row and, of triangles,
 * 4 for that to the point before it there. The cell above begins `shift` points
 * later. */
struct pavement_edges {
    int width, shift;
    const char *rows;
};

extern const struct pavement_edges pavement_list[PAVEMENT_COUNT];

/* The parameters of the pattern. Of the corners of tiles 0 is pointed, 1 is
 * broken, 2 is round. `form` is of corners that the border
 * turns at slowly (in squares, of cells within a bend; 3: those are as all
 * others), `exterior` of those that it turns at quickly, `interior` of those
 * that other tiles have there. */
struct pavement {
    int sides, tiles, pattern;
    int exterior, interior, form;
    const struct pavement_edges *edges; /* NULL: look them up */
};

/* How many patterns there are of so many sides and tiles; 0: no such tiles. */
int pavement_patterns(int sides, int tiles);

/* The edges of the pavement; NULL if there is none. */
const struct pavement_edges *pavement_find(const struct pavement *pavement);

/* 1 at borders, falling to 0 at the middles of the cells, in [0,1]. Needs
 * `edges`. */
double pavement_value(const struct pavement *pavement, double x, double z);

#endif
