/* The void cut into pieces within which light is taken to be even: each chamber
 * of the skeleton into cells about as wide as its widest ball of void, each
 * connected part of a cell a piece. */
#ifndef SKELETON_PIECES_H
#define SKELETON_PIECES_H

#include "skeleton/chamber.h"

#define PIECE_NONE UINT32_MAX

/* How the box around a chamber is cut. */
struct piece_cells {
    int low[3], high[3]; /* its first voxel, and the one after its last */
    int count[3];        /* cells along each axis */
    double size[3];      /* of a cell, in voxels */
};

struct pieces {
    size_t count, chambers;
    uint32_t *of_voxel;        /* PIECE_NONE: matter, or no node gets there */
    uint32_t *chamber;         /* of each piece */
    struct piece_cells *cells; /* of each chamber */
};

/* `nearest` is graph_nearest's. In the arena. */
struct pieces *pieces_new(struct arena *arena, const struct voxels *voxels,
                          const uint32_t *nearest, const struct graph *graph);

#endif
