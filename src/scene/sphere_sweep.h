/* sphere_sweep: all that a ball passes that moves along a curve and grows or
 * shrinks on its way. */
#ifndef SCENE_SPHERE_SWEEP_H
#define SCENE_SPHERE_SWEEP_H

#include "scene/primitive.h"

enum sweep_kind { SWEEP_LINEAR, SWEEP_CUBIC, SWEEP_B_SPLINE };

struct sweep_segment;
struct sweep_piece;
struct sweep_row;

struct sphere_sweep {
    enum sweep_kind kind;
    struct terms balls; /* x, y, z, radius of each */
    double tolerance;   /* needless */
    struct sweep_segment *segments;
    struct sweep_piece *pieces;
    struct sweep_row *rows; /* of pieces; over them: */
    const struct box_tree *tree;
    struct box3 bounds;
};

enum { SWEEP_BALLS_LIMIT = 1000000 };

extern const struct primitive sphere_sweep_primitive;

#endif
