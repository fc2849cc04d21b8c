/* Curves in a plane, cut where they turn: see outline.h. */
#include "scene/outline.h"

#include <math.h>

#include "base/lesser.h"
#include "base/memory.h"
#include "scene/polynomial.h"

struct segment segment_line(const double a[2], const double b[2])
{
    return (struct segment){ .x = { a[0], b[0] - a[0] },
                             .y = { a[1], b[1] - a[1] },
                             .end = { b[0], b[1] } };
}

struct segment segment_quadratic(const double a[2], const double b[2],
                                 const double c[2])
{
    return (struct segment){
        .x = { a[0], 2 * (b[0] - a[0]), a[0] - 2 * b[0] + c[0] },
        .y = { a[1], 2 * (b[1] - a[1]), a[1] - 2 * b[1] + c[1] },
        .end = { c[0], c[1] },
    };
}

struct segment segment_cubic(const double a[2], const double b[2],
                             const double c[2], const double d[2])
{
    struct segment segment = { .end = { d[0], d[1] } };
    for (int i = 0; i < 2; i++) {
        double *to = i ? segment.y : segment.x;
        to[0] = a[i];
        to[1] = 3 * (b[i] - a[i]);
        to[2] = 3 * (a[i] - 2 * b[i] + c[i]);
        to[3] = d[i] - a[i] + 3 * (b[i] - c[i]);
    }
    return segment;
}

struct segment segment_parabola(const double a[2], const double b[2],
                                const double c[2])
{
    struct segment segment = { .end = { c[0], c[1] } };
    for (int i = 0; i < 2; i++) {
        double *to = i ? segment.y : segment.x;
        to[0] = b[i];
        to[1] = 0.5 * (c[i] - a[i]);
        to[2] = 0.5 * (a[i] + c[i]) - b[i];
    }
    return segment;
}

struct segment segment_spline(const double a[2], const double b[2],
                              const double c[2], const double d[2])
{
    struct segment segment = { .end = { c[0], c[1] } };
    for (int i = 0; i < 2; i++) {
        double *to = i ? segment.y : segment.x;
        to[0] = b[i];
        to[1] = 0.5 * (c[i] - a[i]);
        to[2] = a[i] - 2.5 * b[i] + 2 * c[i] - 0.5 * d[i];
        to[3] = 0.5 * (d[i] - a[i]) + 1.5 * (b[i] - c[i]);
    }
    return segment;
}

static double cubic_at(const double c[4], double s)
{
    return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
}

static double cubic_slope(const double c[4], double s)
{
    return (3 * c[3] * s + 2 * c[2]) * s + c[1];
}

void segment_point(const struct segment *segment, double s, double point[2])
{
    point[0] = cubic_at(segment->x, s);
    point[1] = cubic_at(segment->y, s);
}

void segment_tangent(const struct segment *segment, double s, double tangent[2])
{
    tangent[0] = cubic_slope(segment->x, s);
    tangent[1] = cubic_slope(segment->y, s);
}

/* It is among its control points. */
struct rectangle segment_box(const struct segment *segment)
{
    struct rectangle box;
    for (int i = 0; i < 2; i++) {
        const double *c = i ? segment->y : segment->x;
        double control[4] = { c[0], c[0] + c[1] / 3,
                              c[0] + (2 * c[1] + c[2]) / 3,
                              c[0] + c[1] + c[2] + c[3] };
        double rounding =
            1e-14 * (fabs(c[0]) + fabs(c[1]) + fabs(c[2]) + fabs(c[3]));
        double low = control[0], high = control[0];
        for (int k = 1; k < 4; k++) {
            low = lesser(low, control[k]);
            high = greater(high, control[k]);
        }
        box.low[i] = low - rounding;
        box.high[i] = high + rounding;
    }
    return box;
}

/* Where the cubic turns between 0 and 1: at most twice. */
static int cubic_turns(const double c[4], double turns[2])
{
    double roots[2];
    int count = 0, found = quadratic_roots(3 * c[3], c[2], c[1], roots);
    for (int i = 0; i < found; i++)
        if (roots[i] > 0 && roots[i] < 1)
            turns[count++] = roots[i];
    return count;
}

/* A root is between low and high, and as good as known at s. */
struct cubic_search {
    double low, high;
    bool below; /* the values at low are below 0, those at high are not */
    double s;
};

/* Whether s is the root; if not, it is nearer to it afterwards, by Halley's
 * step: as Newton's, of the curve's bend too. The cube of a step tells how much
 * is left after it, far less than a rounding most often: then nobody need look.
 */
static inline bool cubic_step(const double c[4], struct cubic_search *in,
                              double value)
{
    double last = in->s, slope = cubic_slope(c, last);
    double bend = 3 * c[3] * last + c[2], square = slope * slope;
    if (value == 0)
        return true;
    *((value < 0) == in->below ? &in->low : &in->high) = last;
    in->s -= value * slope / (square - value * bend);
    if (!(in->s > in->low && in->s < in->high)) {
        in->s = 0.5 * (in->low + in->high);
        return fabs(in->s - last) <= 1e-15;
    }
    double step = fabs(in->s - last);
    double left = (bend * bend + fabs(c[3] * slope)) * step * step * step;
    return step <= 1e-15 || left <= 1e-17 * square;
}

/* Its root between low and high, where it has the values f and g of different
 * signs and only grows or only shrinks: steps that are kept in the bracket. */
static double cubic_root(const double c[4], double low, double high, double f,
                         double g)
{
    double s = low + (high - low) * (f / (f - g));
    if (c[2] == 0 && c[3] == 0)
        return s;
    struct cubic_search in = { low, high, f < 0, s };
    for (int round = 0; round < 60; round++)
        if (cubic_step(c, &in, cubic_at(c, in.s)))
            break;
    return in.s;
}

/* The curve between two of its parameters, from 0 to 1 anew. */
static void cubic_part(const double c[4], double low, double high,
                       double part[4])
{
    double w = high - low;
    part[0] = cubic_at(c, low);
    part[1] = w * cubic_slope(c, low);
    part[2] = w * w * (c[2] + 3 * c[3] * low);
    part[3] = w * w * w * c[3];
}

/* A part of a segment; returns whether it has a length. */
static bool piece_cut(const struct segment *segment, double low, double high,
                      struct piece *piece)
{
    *piece = (struct piece){ .outward = 1 };
    struct segment *curve = &piece->curve;
    cubic_part(segment->x, low, high, curve->x);
    cubic_part(segment->y, low, high, curve->y);
    if (high < 1)
        segment_point(segment, high, curve->end);
    else
        memcpy(curve->end, segment->end, sizeof curve->end);
    piece->low[0] = fmin(curve->x[0], curve->end[0]);
    piece->low[1] = fmin(curve->y[0], curve->end[1]);
    piece->high[0] = fmax(curve->x[0], curve->end[0]);
    piece->high[1] = fmax(curve->y[0], curve->end[1]);
    return piece->low[0] < piece->high[0] || piece->low[1] < piece->high[1];
}

enum { SEGMENT_PIECES = 5 }; /* two turns of x and two of y */

/* The pieces of a segment; returns how many. */
static size_t segment_cut(const struct segment *segment,
                          struct piece pieces[SEGMENT_PIECES])
{
    double at[SEGMENT_PIECES + 1] = { 0 };
    size_t made = 0;
    int count = 1;
    count += cubic_turns(segment->x, at + count);
    count += cubic_turns(segment->y, at + count);
    at[count++] = 1;
    for (int i = 1; i < count; i++)
        for (int k = i; at[k] < at[k - 1]; k--) {
            double swap = at[k];
            at[k] = at[k - 1];
            at[k - 1] = swap;
        }
    for (int i = 1; i < count; i++)
        if (at[i] > at[i - 1])
            made += piece_cut(segment, at[i - 1], at[i], &pieces[made]);
    return made;
}

/* While an outline is made, which of its pieces are beside a point: bands of y,
 * of the same height, and the pieces that reach into each. */
struct bands {
    double low, scale; /* y to bands */
    size_t count;
    uint32_t *begin; /* count + 1: where each one's members are */
    uint32_t *members;
};

enum { BAND_PIECES = 4, BAND_SHARES = 8 }; /* in a band; bands of a piece */

static size_t band_at(const struct bands *bands, double y)
{
    double band = (y - bands->low) * bands->scale;
    if (!(band > 0))
        return 0;
    return band < (double)bands->count ? (size_t)band : bands->count - 1;
}

/* How many members there are in all. */
static size_t bands_members(const struct bands *bands,
                            const struct outline *outline)
{
    size_t members = 0;
    for (size_t i = 0; i < outline->count; i++)
        members += band_at(bands, outline->pieces[i].high[1]) -
                   band_at(bands, outline->pieces[i].low[1]) + 1;
    return members;
}

/* Of pieces that are long and upright fewer bands, which would all have the
 * same members. Freed with memory_free(begin). */
static struct bands bands_new(const struct outline *outline)
{
    double low = outline->low[1], size = outline->high[1] - low;
    struct bands bands = { .low = low,
                           .count = outline->count / BAND_PIECES + 1 };
    size_t members;
    for (;; bands.count /= 2) {
        bands.scale = size > 0 ? (double)bands.count / size : 0;
        members = bands_members(&bands, outline);
        if (members <= BAND_SHARES * outline->count || bands.count == 1)
            break;
    }
    bands.begin = memory_new((bands.count + 1 + members) * sizeof(uint32_t));
    bands.members = bands.begin + bands.count + 1;
    for (size_t i = 0; i < outline->count; i++)
        for (size_t b = band_at(&bands, outline->pieces[i].low[1]);
             b <= band_at(&bands, outline->pieces[i].high[1]); b++)
            bands.begin[b]++;
    for (size_t b = 0, at = 0; b <= bands.count; b++)
        bands.begin[b] = (uint32_t)(at += bands.begin[b]);
    for (size_t i = outline->count; i-- > 0;)
        for (size_t b = band_at(&bands, outline->pieces[i].low[1]);
             b <= band_at(&bands, outline->pieces[i].high[1]); b++)
            bands.members[--bands.begin[b]] = (uint32_t)i;
    return bands;
}

static bool piece_is_right(const struct piece *piece, double x, double y);

/* Whether something of the outline may be to the right of the point. */
static inline bool outline_reaches(const struct outline *outline, double x,
                                   double y)
{
    return x <= outline->high[0] && y >= outline->low[1] &&
           y <= outline->high[1];
}

/* As outline_covers. */
static bool bands_cover(const struct bands *bands,
                        const struct outline *outline, double x, double y)
{
    bool odd = false;
    if (!outline_reaches(outline, x, y))
        return false;
    size_t band = band_at(bands, y);
    for (uint32_t i = bands->begin[band]; i < bands->begin[band + 1]; i++)
        odd ^= piece_is_right(&outline->pieces[bands->members[i]], x, y);
    return odd;
}

/* Which side of the piece is out: looked at from a little beside it. */
static double piece_outward(const struct outline *outline,
                            const struct bands *bands,
                            const struct piece *piece)
{
    double p[2], t[2];
    segment_point(&piece->curve, 0.5, p);
    segment_tangent(&piece->curve, 0.5, t);
    double size = hypot(outline->high[0] - outline->low[0],
                        outline->high[1] - outline->low[1]);
    double step = 1e-6 * size / hypot(t[0], t[1]);
    return bands_cover(bands, outline, p[0] + step * t[1], p[1] - step * t[0])
               ? -1
               : 1;
}

/* Cut twice, since there may be many outlines and each takes only what it
 * needs. */
static void outline_cut(struct outline *outline, struct arena *arena,
                        const struct segment *segments, size_t count)
{
    struct piece pieces[SEGMENT_PIECES];
    for (size_t i = 0; i < count; i++)
        outline->count += segment_cut(&segments[i], pieces);
    outline->pieces = ARENA_ARRAY(arena, struct piece, outline->count);
    struct piece *next = outline->pieces;
    for (size_t i = 0; i < count; i++) {
        size_t made = segment_cut(&segments[i], pieces);
        memcpy(next, pieces, made * sizeof *next);
        next += made;
    }
}

struct outline outline_new(struct arena *arena, const struct segment *segments,
                           size_t count)
{
    struct outline outline = {
        .low = { HUGE_VAL, HUGE_VAL },
        .high = { -HUGE_VAL, -HUGE_VAL },
    };
    outline_cut(&outline, arena, segments, count);
    for (size_t i = 0; i < outline.count; i++)
        for (int k = 0; k < 2; k++) {
            const struct piece *piece = &outline.pieces[i];
            outline.low[k] = fmin(outline.low[k], piece->low[k]);
            outline.high[k] = fmax(outline.high[k], piece->high[k]);
        }
    struct bands bands = bands_new(&outline);
    for (size_t i = 0; i < outline.count; i++)
        outline.pieces[i].outward =
            piece_outward(&outline, &bands, &outline.pieces[i]);
    memory_free(bands.begin);
    return outline;
}

struct outline outline_of_numbers(struct arena *arena, const double *numbers,
                                  size_t count)
{
    return outline_new(arena, (const struct segment *)(const void *)numbers,
                       count / SEGMENT_NUMBERS);
}

/* Whether x is below that of the curve where y, whose coefficients are c, is 0.
 * The search ends where the rest of the curve, which doesn't turn, is on one
 * side. */
static bool piece_passes_right(const struct segment *curve, const double c[4],
                               double x, double start)
{
    struct cubic_search in = { 0, 1, c[0] < 0, start };
    bool rises = curve->end[0] > curve->x[0];
    for (int round = 0; round < 60; round++) {
        double value = cubic_at(c, in.s), here = cubic_at(curve->x, in.s);
        bool later = (value < 0) == in.below, most = later != rises;
        if (value == 0 || (c[2] == 0 && c[3] == 0))
            return x < here;
        if (most ? x >= here : x < here)
            return !most;
        if (cubic_step(c, &in, value))
            break;
    }
    return x < cubic_at(curve->x, in.s);
}

/* Whether the horizontal line to the right of the point meets the piece; ends
 * count once. */
static bool piece_is_right(const struct piece *piece, double x, double y)
{
    const struct segment *curve = &piece->curve;
    double f = curve->y[0] - y, g = curve->end[1] - y;
    if ((f > 0) == (g > 0) || x >= piece->high[0])
        return false;
    if (x < piece->low[0])
        return true;
    double c[4] = { f, curve->y[1], curve->y[2], curve->y[3] };
    return piece_passes_right(curve, c, x, f / (f - g));
}

bool outline_covers(const struct outline *outline, double x, double y)
{
    bool odd = false;
    if (!outline_reaches(outline, x, y))
        return false;
    for (size_t i = 0; i < outline->count; i++)
        odd ^= piece_is_right(&outline->pieces[i], x, y);
    return odd;
}

/* The same of points side by side, where it is the box that decides: turns
 * `odd` round. Where it is the curve it is doubtful. */
CLONES static void piece_beside(const struct piece *restrict piece,
                                const double *restrict x,
                                const double *restrict y,
                                lane_flag *restrict odd,
                                lane_flag *restrict doubtful)
{
    const double begin = piece->curve.y[0], end = piece->curve.end[1];
    const double low = piece->low[0], high = piece->high[0];
    const struct lane_run run = lane_run_all();
    EACH_LANE(i, run) {
        double f = begin - y[i], g = end - y[i];
        lane_flag passes = (f > 0 ? -1 : 0) ^ (g > 0 ? -1 : 0);
        lane_flag right = x[i] < low ? -1 : 0;
        lane_flag within = x[i] < high ? -1 : 0;
        odd[i] ^= passes & right;
        doubtful[i] = passes & within & ~right;
    }
}

CLONES static void outline_may_cover(const struct outline *restrict outline,
                                     const double *restrict x,
                                     const double *restrict y,
                                     lane_flag *restrict may)
{
    const double high = outline->high[0], top = outline->high[1];
    const double bottom = outline->low[1];
    const struct lane_run run = lane_run_all();
    EACH_LANE(i, run)
        may[i] = (x[i] <= high ? -1 : 0) & (y[i] >= bottom ? -1 : 0) &
                 (y[i] <= top ? -1 : 0);
}

/* Where the points of `lanes`, one at least, are. */
struct stretch {
    double left, bottom, top;
};

static struct stretch lanes_stretch(const double x[RAY_LANES],
                                    const double y[RAY_LANES], unsigned lanes)
{
    int first = __builtin_ctz(lanes);
    struct stretch all = { x[first], y[first], y[first] };
    for (; lanes; lanes &= lanes - 1) {
        int i = __builtin_ctz(lanes);
        all.left = lesser(all.left, x[i]);
        all.bottom = lesser(all.bottom, y[i]);
        all.top = greater(all.top, y[i]);
    }
    return all;
}

unsigned outline_covers_many(const struct outline *outline,
                             const double x[RAY_LANES],
                             const double y[RAY_LANES], unsigned lanes)
{
    LANE_LINES lane_flag odd[RAY_LANES], flags[RAY_LANES];
    unsigned turned = 0;
    outline_may_cover(outline, x, y, flags);
    lanes &= rays_bits(flags);
    if (!lanes)
        return 0;
    const struct stretch from = lanes_stretch(x, y, lanes);
    memset(odd, 0, sizeof odd);
    for (size_t k = 0; k < outline->count; k++) {
        const struct piece *piece = &outline->pieces[k];
        if (from.left >= piece->high[0] || from.top < piece->low[1] ||
            from.bottom > piece->high[1])
            continue;
        piece_beside(piece, x, y, odd, flags);
        for (unsigned left = lanes & rays_bits(flags); left; left &= left - 1) {
            int i = __builtin_ctz(left);
            turned ^= (unsigned)piece_is_right(piece, x[i], y[i]) << i;
        }
    }
    return lanes & (rays_bits(odd) ^ turned);
}

/* Whether the line passes the piece's box. */
static inline bool piece_is_near(const struct piece *piece, double a, double b,
                                 double c)
{
    double low0 = piece->low[0], high0 = piece->high[0];
    double low1 = piece->low[1], high1 = piece->high[1];
    double low = a * (a > 0 ? low0 : high0) + b * (b > 0 ? low1 : high1) + c;
    double high = a * (a > 0 ? high0 : low0) + b * (b > 0 ? high1 : low1) + c;
    return !((low > 0) | (high < 0));
}

CLONES void outline_crosses_many(const struct piece *restrict piece,
                                 const struct outline_lines *restrict lines,
                                 lane_flag *restrict met)
{
    const struct piece box = *piece;
    for (int i = 0; i < RAY_LANES; i++) {
        const struct rectangle ground = {
            { lines->low[0][i], lines->low[1][i] },
            { lines->high[0][i], lines->high[1][i] }
        };
        bool near = piece_is_near(&box, lines->line[0][i], lines->line[1][i],
                                  lines->line[2][i]);
        met[i] = (near & rectangle_has(&ground, &box)) ? -1 : 0;
    }
}

/* Signs at ends are those of the numbers that neighbours share. */
void outline_cross(const struct outline *outline, int index,
                   const double line[3], outline_visit *visit, void *context)
{
    const struct piece *piece = &outline->pieces[index];
    const struct segment *curve = &piece->curve;
    double a = line[0], b = line[1], c = line[2];
    if (!piece_is_near(piece, a, b, c))
        return;
    double side[4], turns[4] = { 0 };
    for (int i = 0; i < 4; i++)
        side[i] = a * curve->x[i] + b * curve->y[i];
    side[0] += c;
    int count = 1 + cubic_turns(side, turns + 1);
    turns[count] = 1;
    double f = side[0];
    for (int i = 1; i <= count; i++) {
        double g = i < count ? cubic_at(side, turns[i])
                             : a * curve->end[0] + b * curve->end[1] + c;
        if ((f > 0) != (g > 0))
            visit(context, index,
                  cubic_root(side, turns[i - 1], turns[i], f, g));
        f = g;
    }
}
