/* Curves through points at given times: spline { 0, <0,0>, 1, <2,1> ... }.
 * What each kind does between its points, and beyond them, was measured. */
#ifndef SCENE_SPLINE_H
#define SCENE_SPLINE_H

#include "base/arena.h"

enum { SPLINE_SIZE = 5 }; /* the most numbers that a point has */

enum spline_kind {
    SPLINE_LINEAR,
    SPLINE_QUADRATIC,
    SPLINE_CUBIC,
    SPLINE_NATURAL,
};

struct spline_knot {
    double time;
    double place[SPLINE_SIZE];
    double bend[SPLINE_SIZE]; /* of the natural spline: the second derivative */
};

struct spline {
    enum spline_kind kind;
    int size; /* numbers of a point, 2 to SPLINE_SIZE */
    struct {
        struct spline_knot *items; /* by time */
        size_t count, capacity;
    } knots; /* one at least */
};

/* Puts the knots in order, of two of one time the second, and computes the
 * bends. The knots are in `arena`. */
void spline_prepare(struct spline *spline, struct arena *arena);

/* The place at a time, as a spline of this kind: `size` numbers. */
void spline_at(const struct spline *spline, enum spline_kind kind, double time,
               double place[SPLINE_SIZE]);

#endif
