/* Outlines in a plane: closed curves of straight, quadratic and cubic
 * segments. What an odd number of them surrounds is inside. Prisms and the
 * letters of `text` are outlines with a thickness. */
#ifndef SCENE_OUTLINE_H
#define SCENE_OUTLINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "scene/rays.h"

/* A curve x(s), y(s), 0 <= s <= 1, by its coefficients of 1, s, s^2, s^3, and
 * its end, which is exactly where the next one begins: so no ray slips through
 * between them. */
struct segment {
    double x[4], y[4];
    double end[2];
};

enum { SEGMENT_NUMBERS = sizeof(struct segment) / sizeof(double) };

/* The straight line, and the Bezier curves of 3 and of 4 points. */
struct segment segment_line(const double a[2], const double b[2]);
struct segment segment_quadratic(const double a[2], const double b[2],
                                 const double c[2]);
struct segment segment_cubic(const double a[2], const double b[2],
                             const double c[2], const double d[2]);

/* From b to c, as POV-Ray's splines go there: the parabola through all three,
 * with s = -1 at a, and the cubic with the slopes of a-c and b-d. */
struct segment segment_parabola(const double a[2], const double b[2],
                                const double c[2]);
struct segment segment_spline(const double a[2], const double b[2],
                              const double c[2], const double d[2]);

void segment_point(const struct segment *segment, double s, double point[2]);
void segment_tangent(const struct segment *segment, double s,
                     double tangent[2]);

struct rectangle {
    double low[2], high[2];
};

/* Has each point that segment_point tells, roundings and all. */
struct rectangle segment_box(const struct segment *segment);

/* A part of a segment along which x and y only grow or only shrink. */
struct piece {
    struct segment curve;
    double low[2], high[2];
    double outward; /* 1 or -1: (y', -x') times it points out */
};

struct outline {
    struct piece *pieces;
    size_t count;
    double low[2], high[2];
};

/* Whether it has any of the piece's box. */
static inline bool rectangle_has(const struct rectangle *rectangle,
                                 const struct piece *piece)
{
    const double *low = rectangle->low, *high = rectangle->high;
    return (low[0] <= piece->high[0]) & (high[0] >= piece->low[0]) &
           (low[1] <= piece->high[1]) & (high[1] >= piece->low[1]);
}

/* The outline of these segments, in memory of the arena. */
struct outline outline_new(struct arena *arena, const struct segment *segments,
                           size_t count);

/* The same of segment after segment, SEGMENT_NUMBERS each. */
struct outline outline_of_numbers(struct arena *arena, const double *numbers,
                                  size_t count);

/* Whether an odd number of curves is to the right of the point. */
bool outline_covers(const struct outline *outline, double x, double y);

/* The same of points side by side, bit by bit of `lanes`. */
unsigned outline_covers_many(const struct outline *outline,
                             const double x[RAY_LANES],
                             const double y[RAY_LANES], unsigned lanes);

/* Calls for each crossing of that piece with the line line[0] x + line[1] y +
 * line[2] = 0. */
typedef void outline_visit(void *context, int piece, double s);
void outline_cross(const struct outline *outline, int piece,
                   const double line[3], outline_visit *visit, void *context);

/* Lines side by side, and rectangles of the plane in which they count. */
struct outline_lines {
    LANE_LINES double line[3][RAY_LANES], low[2][RAY_LANES], high[2][RAY_LANES];
};

/* Which of them may cross the piece: where it says no, outline_cross finds
 * nothing in the rectangle. */
void outline_crosses_many(const struct piece *piece,
                          const struct outline_lines *lines, lane_flag *met);

#endif
