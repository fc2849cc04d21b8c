/* The void as a cubical complex: a set of cells, products of unit intervals and
 * points, that contains every face of each of its cells. A cell has Khalimsky
 * coordinates: odd along an axis where it is an interval, even where it is a
 * point (Kovalevsky 1989). One byte holds the eight cells of a lattice point;
 * bit i of it the one whose intervals are along the axes set in i.
 *
 * Void voxels that share no more than a corner are connected in it: matter must
 * be voxelised as a supercover. */
#ifndef SKELETON_COMPLEX_H
#define SKELETON_COMPLEX_H

#include <stdbool.h>

#include "skeleton/voxels.h"

/* Eight times the lattice point plus the axes: 3 bits, 1 for x, 2 y, 4 z. */
typedef uint32_t cell;

/* Voxels in a grid at most, whose sides are of 2048: then cells fit in their
 * type, though there are a few more lattice points. */
enum { COMPLEX_VOXELS_MAX = 500000000 };

struct complex {
    int size[3];    /* lattice points: voxels + 1, and one that stays empty */
    cell stride[3]; /* between neighbouring lattice points, of cells */
    size_t count;   /* lattice points in all */
    uint8_t *cells;
};

/* The closure of all void voxels; freed by complex_free. */
struct complex *complex_new(const struct voxels *voxels);
void complex_free(struct complex *complex);

/* #points - #edges + #squares - #cubes: collapsing keeps it. */
long complex_euler(const struct complex *complex);

/* How many cells there are of each dimension. */
struct complex_counts {
    long of[4];
};
struct complex_counts complex_count(const struct complex *complex);

/* The voxel, and one along the axes of `c`, for a cell; the coordinate along
 * an axis is that of the voxel above the lattice point. */
void complex_place(const struct complex *complex, cell c, int place[3]);

static inline bool complex_has(const uint8_t *cells, cell c)
{
    return cells[c >> 3] >> (c & 7) & 1;
}

static inline void complex_set(uint8_t *cells, cell c)
{
    cells[c >> 3] |= (uint8_t)(1u << (c & 7));
}

static inline void complex_clear(uint8_t *cells, cell c)
{
    cells[c >> 3] &= (uint8_t) ~(1u << (c & 7));
}

static inline int cell_dimension(cell c)
{
    return (int)((c & 1) + (c >> 1 & 1) + (c >> 2 & 1));
}

/* The neighbour of one dimension more along an axis that `c` has not. */
static inline cell cell_above(cell c, int axis)
{
    return c | 1u << axis;
}

static inline cell cell_below(const struct complex *complex, cell c, int axis)
{
    return (c - complex->stride[axis]) | 1u << axis;
}

/* The two faces along an axis that `c` has. */
static inline cell cell_low_face(cell c, int axis)
{
    return c & ~(1u << axis);
}

static inline cell cell_high_face(const struct complex *complex, cell c,
                                  int axis)
{
    return cell_low_face(c, axis) + complex->stride[axis];
}

enum { CLOSURE_MAX = 27 };

/* The cell and all its faces, of all dimensions; how many. */
int cell_closure(const struct complex *complex, cell c,
                 cell closure[CLOSURE_MAX]);

#endif
