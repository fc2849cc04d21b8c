/* Curves through points at given times: see spline.h. */
#include "scene/spline.h"

#include <stdlib.h>
#include <string.h>

/* ---- the knots ---- */

struct placed_knot {
    struct spline_knot knot;
    size_t place;
};

static int knot_order(const void *a, const void *b)
{
    const struct placed_knot *p = a, *q = b;
    if (p->knot.time != q->knot.time)
        return p->knot.time < q->knot.time ? -1 : 1;
    return p->place < q->place ? -1 : p->place > q->place;
}

/* By time; those of one time become one. */
static void knots_order(struct spline *spline, struct arena *arena)
{
    struct spline_knot *knots = spline->knots.items;
    size_t count = spline->knots.count, kept = 0;
    struct placed_knot *placed = ARENA_ARRAY(arena, struct placed_knot, count);
    for (size_t i = 0; i < count; i++)
        placed[i] = (struct placed_knot){ knots[i], i };
    qsort(placed, count, sizeof *placed, knot_order);
    for (size_t i = 0; i < count; i++) {
        const struct spline_knot *knot = &placed[i].knot;
        if (kept > 0 && knots[kept - 1].time == knot->time)
            knots[kept - 1] = *knot;
        else
            knots[kept++] = *knot;
    }
    spline->knots.count = kept;
}

/* The second derivatives of the natural cubic spline: 0 at both ends, and such
 * that the first has no jumps. A tridiagonal system, by elimination. */
static void knots_bend(struct spline *spline, struct arena *arena, int part)
{
    struct spline_knot *k = spline->knots.items;
    size_t last = spline->knots.count - 1;
    double *share = ARENA_ARRAY(arena, double, last + 1);
    k[0].bend[part] = k[last].bend[part] = 0;
    for (size_t i = 1; i < last; i++) {
        double before = k[i].time - k[i - 1].time;
        double after = k[i + 1].time - k[i].time;
        double right = (k[i + 1].place[part] - k[i].place[part]) / after -
                       (k[i].place[part] - k[i - 1].place[part]) / before;
        double pivot = 2 * (before + after) - before * share[i - 1];
        share[i] = after / pivot;
        k[i].bend[part] = (6 * right - before * k[i - 1].bend[part]) / pivot;
    }
    for (size_t i = last; i-- > 1;)
        k[i].bend[part] -= share[i] * k[i + 1].bend[part];
}

void spline_prepare(struct spline *spline, struct arena *arena)
{
    knots_order(spline, arena);
    for (int part = 0; part < SPLINE_SIZE; part++)
        knots_bend(spline, arena, part);
}

/* ---- between them ---- */

/* The last knot but one that is not after the time. */
static size_t knots_find(const struct spline *spline, double time)
{
    size_t low = 0, high = spline->knots.count - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (spline->knots.items[middle].time <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static double line_at(const struct spline_knot *k, double time, int part)
{
    double share = (time - k[0].time) / (k[1].time - k[0].time);
    return k[0].place[part] + share * (k[1].place[part] - k[0].place[part]);
}

/* The parabola through three knots. */
static double parabola_at(const struct spline_knot *k, double time, int part)
{
    double a = time - k[0].time, b = time - k[1].time, c = time - k[2].time;
    double ab = k[1].time - k[0].time, bc = k[2].time - k[1].time;
    return k[0].place[part] * b * c / (ab * (ab + bc)) -
           k[1].place[part] * a * c / (ab * bc) +
           k[2].place[part] * a * b / ((ab + bc) * bc);
}

static double knots_slope(const struct spline_knot *k, int part)
{
    return (k[1].place[part] - k[0].place[part]) / (k[1].time - k[0].time);
}

/* Hermite's cubic between two knots; the slope at each is the mean of those of
 * the lines on both sides. k[-1] and k[2] exist. */
static double cubic_at(const struct spline_knot *k, double time, int part)
{
    double h = k[1].time - k[0].time, u = (time - k[0].time) / h, v = 1 - u;
    double line = knots_slope(k, part);
    double from = 0.5 * (knots_slope(k - 1, part) + line);
    double to = 0.5 * (line + knots_slope(k + 1, part));
    return k[0].place[part] * v * v * (1 + 2 * u) +
           k[1].place[part] * u * u * (1 + 2 * v) +
           h * u * v * (from * v - to * u);
}

static double natural_at(const struct spline_knot *k, double time, int part)
{
    double h = k[1].time - k[0].time;
    double u = (time - k[0].time) / h, v = 1 - u;
    return v * k[0].place[part] + u * k[1].place[part] +
           h * h / 6 *
               ((v * v * v - v) * k[0].bend[part] +
                (u * u * u - u) * k[1].bend[part]);
}

/* The times that the spline spans: a cubic one its second to its last but one
 * (measured: of three knots the middle one alone, of two halfway). */
static double spline_clamp(const struct spline *spline, enum spline_kind kind,
                           double time)
{
    const struct spline_knot *k = spline->knots.items;
    size_t count = spline->knots.count, in = kind == SPLINE_CUBIC;
    double first = k[in].time, last = k[count - 1 - in].time;
    if (first > last)
        return 0.5 * (first + last);
    return time > last ? last : time >= first ? time : first;
}

void spline_at(const struct spline *spline, enum spline_kind kind, double time,
               double place[SPLINE_SIZE])
{
    const struct spline_knot *knots = spline->knots.items;
    size_t count = spline->knots.count;
    memcpy(place, knots[0].place, sizeof knots[0].place);
    if (count == 1)
        return;
    time = spline_clamp(spline, kind, time);
    size_t i = knots_find(spline, time);
    if ((kind == SPLINE_QUADRATIC && count < 3) ||
        (kind == SPLINE_CUBIC && count < 4))
        kind = SPLINE_LINEAR;
    for (int part = 0; part < spline->size; part++)
        switch (kind) {
        case SPLINE_LINEAR:
            place[part] = line_at(knots + i, time, part);
            break;
        case SPLINE_QUADRATIC:
            place[part] = parabola_at(knots + (i > 0 ? i - 1 : 0), time, part);
            break;
        case SPLINE_CUBIC:
            place[part] = i + 2 < count ? cubic_at(knots + i, time, part)
                                        : knots[i].place[part];
            break;
        case SPLINE_NATURAL:
            place[part] = natural_at(knots + i, time, part);
            break;
        }
}
