/* Which cells of a cube around a lamp a triangle may cover. Each side of the
 * cube is cut into edge x edge cells; sides are numbered by twice their axis,
 * one more where that is negative. */
#ifndef LIGHTMESH_CUBE_CELLS_H
#define LIGHTMESH_CUBE_CELLS_H

#include <stdbool.h>

enum { CUBE_SIDES = 6 };

/* A bounding box in cells is so much larger than it seems: rounding. */
#define CELL_SLACK 1e-3f

/* A box of cells on a side, ends included. */
struct cube_box {
    int side, left, top, right, bottom;
};

/* The cells of one side that the triangle covers, and some beside them; its
 * corners as seen from the middle of the cube. False: none. */
bool cube_box_of(const float triangle[3][3], int side, int edge,
                 struct cube_box *box);

#endif
