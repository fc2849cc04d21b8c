/* A parametric surface cut into cells that are nearly flat, and a tree of the
 * boxes around them. In a cell the surface is a plane and a little more, so
 * that Newton's method finds where a ray meets it. */
#ifndef SCENE_PARAMETRIC_SHEET_H
#define SCENE_PARAMETRIC_SHEET_H

#include "scene/box_tree.h"
#include "scene/parametric.h"

/* The rectangle of coordinates middle +- half; there the surface is
 * centre + a across[0] + b across[1], a and b from -1 to 1, but for `bend`. */
struct parametric_cell {
    double middle[2], half[2];
    vec3 centre, across[2];
    double bend;
};

struct parametric_sheet {
    struct parametric_cell *cells;
    size_t count;
    struct box3 bounds;
    const struct box_tree *tree; /* NULL: there is no cell */
};

enum { PARAMETRIC_STEPS = 1000 * 1000 * 1000 }; /* of functions: time */

/* In `arena`; NULL: its functions take more steps than that. */
const struct parametric_sheet *
parametric_sheet_new(const struct parametric *surface, struct arena *arena);

/* Where the line meets the surface in the cell: (t, u, v) of each, at most
 * PARAMETRIC_CROSSINGS; returns how many. Looks at points of the surface are
 * counted down: at 0 no more are found. */
enum {
    PARAMETRIC_CROSSINGS = 4,
    PARAMETRIC_LOOKS = 5000, /* of one ray: time, where a surface is dust */
};
int parametric_cell_cross(const struct parametric *surface,
                          const struct parametric_cell *cell,
                          const struct ray *ray, int *looks_left,
                          double found[PARAMETRIC_CROSSINGS][3]);

#endif
