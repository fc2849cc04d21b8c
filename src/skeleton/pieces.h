/* The void cut into pieces within which light is taken to be even. Each chamber
 * of the skeleton is parted into regions, by how narrow the void is there; and
 * each region into cells, about as wide as its widest ball of void: each
 * connected part of a cell is a piece. */
#ifndef SKELETON_PIECES_H
#define SKELETON_PIECES_H

#include "skeleton/chamber.h"

#define PIECE_NONE UINT32_MAX

/* How the box around a region is cut. */
struct piece_cells {
    int low[3], high[3]; /* its first voxel, and the one after its last */
    int count[3];        /* cells along each axis */
    double size[3];      /* of a cell, in voxels */
};

struct pieces {
    size_t count, regions;
    uint32_t *of_voxel;        /* PIECE_NONE: matter, or no node gets there */
    uint32_t *region;          /* of each piece */
    struct piece_cells *cells; /* of each region */
};

/* How a void was cut, for the other pictures of its animation. */
struct pieces_kept {
    struct voxels grid; /* without `empty` */
    struct pieces pieces;
};

/* One block of memory; freed with memory_free. */
struct pieces_kept *pieces_keep(const struct pieces *pieces,
                                const struct voxels *voxels);

/* `nearest` is graph_nearest's. In a grid like that of `root`, unless that is
 * NULL, the cells are root's, so that what moves changes no more of them than
 * it has to. In the arena. */
struct pieces *pieces_new(struct arena *arena, const struct voxels *voxels,
                          const uint32_t *nearest, const struct graph *graph,
                          const struct pieces_kept *root);

#endif
