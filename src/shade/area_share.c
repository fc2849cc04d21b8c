/* What share of an area light is seen, by points of its grid: see area.h. */
#include <stdlib.h>
#include <string.h>

#include "shade/area.h"

/* Points seen are remembered in a table, because neighbouring parts share
 * their edges. A point that has lost its place is seen again. */
enum { AREA_PLACES = 1021 };

/* Of outlines: how often the light is cut in halves each way before parts are
 * cut along them; and where it isn't adaptive. */
enum { OUTLINE_LEAST = 2, OUTLINE_MOST = 5, OUTLINE_FULL = 3 };

struct area_walk {
    const struct area_grid *grid;
    rgb light; /* unshadowed */
    area_visit *visit;
    void *context;
    bool thorough;              /* outlines */
    int64_t known[AREA_PLACES]; /* number of the point, -1: none */
    rgb seen[AREA_PLACES];
};

/* Part of the grid, both ends included. */
struct area_part {
    int i0, i1, j0, j1;
};

static void area_walk_start(struct area_walk *walk,
                            const struct area_grid *grid, rgb arriving,
                            area_visit *visit, void *context)
{
    walk->grid = grid;
    walk->light = arriving;
    walk->visit = visit;
    walk->context = context;
    int64_t points = (int64_t)grid->size1 * grid->size2;
    size_t places = points < AREA_PLACES ? (size_t)points : AREA_PLACES;
    memset(walk->known, -1, places * sizeof *walk->known);
}

static rgb area_see(struct area_walk *walk, int i, int j)
{
    int64_t number = (int64_t)i * walk->grid->size2 + j;
    size_t place = (size_t)(number % AREA_PLACES);
    if (walk->known[place] != number) {
        struct area_point point = area_grid_at(walk->grid, i, j);
        walk->seen[place] = walk->visit(walk->context, &point);
        walk->known[place] = number;
    }
    return walk->seen[place];
}

/* POV-Ray's measure: less than 0.1 in all of the light that arrives. */
static bool area_agree(const struct area_walk *walk, rgb a, rgb b)
{
    rgb d = rgb_mul(rgb_sub(a, b), walk->light);
    return fabs(d.r) + fabs(d.g) + fabs(d.b) < 0.1;
}

/* A part's corners as they are seen, and what they say. */
struct area_corners {
    rgb a, b, c, d; /* at (i0, j0), (i1, j0), (i0, j1), (i1, j1) */
    bool agree;
};

static struct area_corners area_corners(struct area_walk *walk,
                                        struct area_part part)
{
    struct area_corners at;
    at.a = area_see(walk, part.i0, part.j0);
    at.b = area_see(walk, part.i1, part.j0);
    at.c = area_see(walk, part.i0, part.j1);
    at.d = area_see(walk, part.i1, part.j1);
    at.agree = area_agree(walk, at.a, at.b) && area_agree(walk, at.a, at.c) &&
               area_agree(walk, at.b, at.d) && area_agree(walk, at.c, at.d);
    return at;
}

static rgb corners_mean(const struct area_corners *at)
{
    return rgb_scale(rgb_add(rgb_add(at->a, at->b), rgb_add(at->c, at->d)),
                     0.25);
}

/* The mean of what `share` says of the halves, of a part that can be cut only
 * one way, or of the quarters. Halves overlap in the middle point where there
 * is one. */
static rgb area_halves(struct area_walk *walk, struct area_part part, int level,
                       rgb (*share)(struct area_walk *walk,
                                    struct area_part part, int level))
{
    bool wide = part.i1 - part.i0 > 1, high = part.j1 - part.j0 > 1;
    rgb sum = rgb_grey(0);
    int columns = wide ? 2 : 1, rows = high ? 2 : 1;
    for (int k = 0; k < columns * rows; k++) {
        struct area_part half = part;
        int i = part.i0 + part.i1, j = part.j0 + part.j1;
        if (wide && k % columns == 0)
            half.i1 = i / 2;
        else if (wide)
            half.i0 = (i + 1) / 2;
        if (high && k / columns == 0)
            half.j1 = j / 2;
        else if (high)
            half.j0 = (j + 1) / 2;
        sum = rgb_add(sum, share(walk, half, level + 1));
    }
    return rgb_scale(sum, 1.0 / (columns * rows));
}

/* Depth is limited by the bits of a size. */
static rgb area_part_seen(struct area_walk *walk, struct area_part part,
                          int level)
{
    int adaptive = walk->grid->adaptive;
    struct area_corners at = area_corners(walk, part);
    bool smallest = part.i1 - part.i0 <= 1 && part.j1 - part.j0 <= 1;
    if (smallest || (adaptive >= 0 && level >= adaptive && at.agree))
        return corners_mean(&at);
    return area_halves(walk, part, level, area_part_seen);
}

rgb area_visibility(const struct area_grid *grid, rgb arriving,
                    area_visit *visit, void *context)
{
    struct area_walk walk;
    area_walk_start(&walk, grid, arriving, visit, context);
    return area_part_seen(
        &walk, (struct area_part){ 0, grid->size1 - 1, 0, grid->size2 - 1 }, 0);
}

/* How far from one end of an edge to the other the light changes, 0..1. */
static double edge_cut(struct area_walk *walk, int i0, int j0, int i1, int j1)
{
    rgb first = area_see(walk, i0, j0);
    int steps = abs(i1 - i0) + abs(j1 - j0), low = 0, high = steps;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        rgb seen = area_see(walk, i0 + (i1 - i0) * middle / steps,
                            j0 + (j1 - j0) * middle / steps);
        if (area_agree(walk, first, seen))
            low = middle;
        else
            high = middle;
    }
    return steps > 0 ? (low + high) / (2.0 * steps) : 0.5;
}

/* The corners of a part, around it. */
struct area_ring {
    int i[4], j[4];
    rgb seen[4];
};

static double ring_cut(struct area_walk *walk, const struct area_ring *ring,
                       int from, int to)
{
    from %= 4;
    to %= 4;
    return edge_cut(walk, ring->i[from], ring->j[from], ring->i[to],
                    ring->j[to]);
}

static rgb ring_mean(const struct area_ring *ring, int first, int count)
{
    rgb sum = ring->seen[first % 4];
    for (int k = 1; k < count; k++)
        sum = rgb_add(sum, ring->seen[(first + k) % 4]);
    return rgb_scale(sum, 1.0 / count);
}

/* The share of a part that is like its corner k, unlike the next ones. */
static double ring_triangle(struct area_walk *walk,
                            const struct area_ring *ring, int k)
{
    return ring_cut(walk, ring, k, k + 1) * ring_cut(walk, ring, k, k + 3) / 2;
}

/* The share of a part that is like its corners k and the next, unlike the
 * others. */
static double ring_half(struct area_walk *walk, const struct area_ring *ring,
                        int k)
{
    return (ring_cut(walk, ring, k, k + 3) +
            ring_cut(walk, ring, k + 1, k + 2)) /
           2;
}

/* Corners 0 and 2 are like each other and unlike the others: the middle tells
 * which are joined. */
static rgb saddle_seen(struct area_walk *walk, const struct area_ring *ring)
{
    rgb middle = area_see(walk, (ring->i[0] + ring->i[2]) / 2,
                          (ring->j[0] + ring->j[2]) / 2);
    int alone = area_agree(walk, middle, ring->seen[0]) ? 1 : 0;
    double share =
        ring_triangle(walk, ring, alone) + ring_triangle(walk, ring, alone + 2);
    return rgb_mix(ring->seen[1 - alone], ring->seen[alone], share);
}

/* A part whose corners disagree, cut in two by a straight line. */
static rgb outline_cut(struct area_walk *walk, const struct area_corners *at,
                       struct area_part part)
{
    const struct area_ring ring = {
        { part.i0, part.i1, part.i1, part.i0 },
        { part.j0, part.j0, part.j1, part.j1 },
        { at->a, at->b, at->d, at->c },
    };
    bool like[4];
    int count = 0, odd = 0;
    for (int k = 0; k < 4; k++) {
        like[k] = area_agree(walk, ring.seen[0], ring.seen[k]);
        count += like[k];
        odd = like[k] ? odd : k;
    }
    if (count == 2 && like[2])
        return saddle_seen(walk, &ring);
    if (count == 2) {
        int first = like[1] ? 0 : 3;
        return rgb_mix(ring_mean(&ring, first + 2, 2),
                       ring_mean(&ring, first, 2),
                       ring_half(walk, &ring, first));
    }
    odd = count == 3 ? odd : 0;
    return rgb_mix(ring_mean(&ring, odd + 1, 3), ring.seen[odd],
                   ring_triangle(walk, &ring, odd));
}

static int outline_cuts(int adaptive)
{
    int cuts = adaptive < 0 ? OUTLINE_FULL : adaptive;
    cuts = cuts > OUTLINE_LEAST ? cuts : OUTLINE_LEAST;
    return cuts < OUTLINE_MOST ? cuts : OUTLINE_MOST;
}

/* Dark parts are looked at as closely as `adaptive` asks, for there may be gaps
 * in what hides them; lit ones more closely where it costs little. */
static int outline_least(const struct area_walk *walk, rgb seen)
{
    int adaptive = walk->grid->adaptive;
    int cuts = outline_cuts(adaptive);
    bool lit = rgb_peak(seen) > 0;
    bool closely = lit ? walk->thorough : adaptive < 0 || adaptive >= cuts;
    return closely ? cuts : cuts - 1;
}

static rgb outline_part_seen(struct area_walk *walk, struct area_part part,
                             int level)
{
    int cuts = outline_cuts(walk->grid->adaptive);
    struct area_corners at = area_corners(walk, part);
    if (at.agree && level >= outline_least(walk, at.a))
        return corners_mean(&at);
    if (level >= cuts)
        return outline_cut(walk, &at, part);
    return area_halves(walk, part, level, outline_part_seen);
}

rgb area_outline(const struct area_grid *grid, rgb arriving, bool thorough,
                 area_visit *visit, void *context)
{
    struct area_walk walk;
    area_walk_start(&walk, grid, arriving, visit, context);
    walk.thorough = thorough;
    return outline_part_seen(
        &walk, (struct area_part){ 0, grid->size1 - 1, 0, grid->size2 - 1 }, 0);
}
