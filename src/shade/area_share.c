/* What share of an area light is seen, by points of its grid: see area.h. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "shade/area.h"

/* Points seen are remembered in a table, because neighbouring parts share
 * their edges. A point that has lost its place is seen again. */
enum { AREA_PLACES = 1021 };

/* So many parts at a time are looked at together. */
enum { AREA_FRONT = 256 };

/* Of outlines: how often the light is cut in halves each way before parts are
 * cut along them; and where it isn't adaptive. */
enum { OUTLINE_LEAST = 2, OUTLINE_MOST = 5, OUTLINE_FULL = 3 };

/* Behind one pane light differs by less between places that its author looks
 * at: more is the outline of another. */
static const double pane_even = 0.1;

/* Part of the grid, both ends included, how often it was cut, and how much it
 * counts of the whole. */
struct area_part {
    int i0, i1, j0, j1;
    int level;
    double weight;
};

struct area_walk;

/* What share of the part is seen, by its corners. False if they don't tell: it
 * is to be cut in smaller ones. */
typedef bool area_tells(struct area_walk *walk, const struct area_part *part,
                        rgb *share);

struct area_walk {
    const struct area_grid *grid;
    rgb light; /* unshadowed */
    area_visit *visit;
    void *context;
    area_tells *tells;
    int surely;    /* parts of lower levels always are cut, if they can be */
    bool closely;  /* and parts that look alike may be */
    int asked;     /* outlines: so often dark parts are cut, */
    bool thorough; /* and lit ones once more than surely */
    bool same;     /* all that was seen is like this, to the bit */
    rgb first;
    struct area_points wanted;  /* known soon: their places are taken */
    int64_t known[AREA_PLACES]; /* number of the point, -1: none */
    rgb seen[AREA_PLACES];
};

static void area_walk_start(struct area_walk *walk,
                            const struct area_grid *grid, rgb arriving,
                            area_visit *visit, void *context)
{
    walk->grid = grid;
    walk->light = arriving;
    walk->visit = visit;
    walk->context = context;
    walk->same = true;
    walk->first = rgb_grey(-1);
    walk->wanted.count = 0;
    int64_t points = (int64_t)grid->size1 * grid->size2;
    size_t places = points < AREA_PLACES ? (size_t)points : AREA_PLACES;
    memset(walk->known, -1, places * sizeof *walk->known);
}

static int64_t area_number(const struct area_walk *walk, int i, int j)
{
    return (int64_t)i * walk->grid->size2 + j;
}

static size_t area_place(int64_t number)
{
    return (size_t)(number < AREA_PLACES ? number : number % AREA_PLACES);
}

static bool rgb_same(rgb a, rgb b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* Sees all that are wanted. */
static void area_flush(struct area_walk *walk)
{
    struct area_points *wanted = &walk->wanted;
    rgb seen[RAY_LANES];
    if (wanted->count == 0)
        return;
    area_grid_points(walk->grid, wanted);
    walk->visit(walk->context, wanted, seen);
    if (walk->first.r < 0)
        walk->first = seen[0];
    for (int k = 0; k < wanted->count; k++) {
        int64_t number =
            area_number(walk, (int)wanted->at[0][k], (int)wanted->at[1][k]);
        walk->known[area_place(number)] = number;
        walk->seen[area_place(number)] = seen[k];
        walk->same = walk->same && rgb_same(walk->first, seen[k]);
    }
    wanted->count = 0;
}

/* Has the point seen in advance, with others. */
static void area_want(struct area_walk *walk, int i, int j)
{
    struct area_points *wanted = &walk->wanted;
    int64_t number = area_number(walk, i, j);
    if (walk->known[area_place(number)] == number)
        return;
    walk->known[area_place(number)] = number;
    wanted->at[0][wanted->count] = i;
    wanted->at[1][wanted->count++] = j;
    if (wanted->count == RAY_LANES)
        area_flush(walk);
}

static rgb area_see(struct area_walk *walk, int i, int j)
{
    int64_t number = area_number(walk, i, j);
    size_t place = area_place(number);
    if (walk->known[place] != number) {
        area_want(walk, i, j);
        area_flush(walk);
    }
    return walk->seen[place];
}

/* POV-Ray's measure: less than 0.1 in all of the light that arrives. */
static bool area_agree(const struct area_walk *walk, rgb a, rgb b)
{
    if (rgb_same(a, b))
        return true;
    rgb d = rgb_mul(rgb_sub(a, b), walk->light);
    return fabs(d.r) + fabs(d.g) + fabs(d.b) < 0.1;
}

/* A part's corners as they are seen. */
struct area_corners {
    rgb a, b, c, d; /* at (i0, j0), (i1, j0), (i0, j1), (i1, j1) */
};

static struct area_corners area_corners(struct area_walk *walk,
                                        const struct area_part *part)
{
    struct area_corners at;
    at.a = area_see(walk, part->i0, part->j0);
    at.b = area_see(walk, part->i1, part->j0);
    at.c = area_see(walk, part->i0, part->j1);
    at.d = area_see(walk, part->i1, part->j1);
    return at;
}

static bool corners_agree(const struct area_walk *walk,
                          const struct area_corners *at)
{
    return area_agree(walk, at->a, at->b) && area_agree(walk, at->a, at->c) &&
           area_agree(walk, at->b, at->d) && area_agree(walk, at->c, at->d);
}

static rgb corners_mean(const struct area_corners *at)
{
    return rgb_scale(rgb_add(rgb_add(at->a, at->b), rgb_add(at->c, at->d)),
                     0.25);
}

static bool part_is_smallest(const struct area_part *part)
{
    return part->i1 - part->i0 <= 1 && part->j1 - part->j0 <= 1;
}

/* Its quarters, or the halves of one that can be cut only one way; they overlap
 * in the middle point where there is one. Returns how many. */
static int part_cut(const struct area_part *part, struct area_part cut[4])
{
    bool wide = part->i1 - part->i0 > 1, high = part->j1 - part->j0 > 1;
    int columns = wide ? 2 : 1, rows = high ? 2 : 1;
    int i = part->i0 + part->i1, j = part->j0 + part->j1;
    for (int k = 0; k < columns * rows; k++) {
        cut[k] = *part;
        cut[k].level++;
        cut[k].weight /= columns * rows;
        if (wide && k % columns == 0)
            cut[k].i1 = i / 2;
        else if (wide)
            cut[k].i0 = (i + 1) / 2;
        if (high && k / columns == 0)
            cut[k].j1 = j / 2;
        else if (high)
            cut[k].j0 = (j + 1) / 2;
    }
    return columns * rows;
}

static bool part_surely_cut(const struct area_walk *walk,
                            const struct area_part *part)
{
    return part->level < walk->surely && !part_is_smallest(part);
}

/* Parts of one level that are looked at. */
struct area_front {
    int count;
    bool full; /* there are more */
    struct area_part at[AREA_FRONT];
};

/* Wants the corners of the part, and of what it is surely cut into. Depth is
 * limited by the bits of a size. */
static void area_foresee_part(struct area_walk *walk,
                              const struct area_part *part,
                              struct area_front *front)
{
    struct area_part cut[4];
    area_want(walk, part->i0, part->j0);
    area_want(walk, part->i1, part->j0);
    area_want(walk, part->i0, part->j1);
    area_want(walk, part->i1, part->j1);
    if (part_surely_cut(walk, part)) {
        int count = part_cut(part, cut);
        for (int k = 0; k < count; k++)
            area_foresee_part(walk, &cut[k], front);
    } else if (front->count < AREA_FRONT) {
        front->at[front->count++] = *part;
    } else {
        front->full = true;
    }
}

/* Adds up the shares of those that are told; the others are cut for the next
 * front. */
static void front_tell(struct area_walk *walk, const struct area_front *front,
                       struct area_front *next, rgb *sum)
{
    struct area_part cut[4];
    int left[AREA_FRONT], count = 0;
    rgb share;
    for (int n = 0; n < front->count; n++)
        if (walk->tells(walk, &front->at[n], &share))
            *sum = rgb_add_scaled(*sum, share, front->at[n].weight);
        else
            left[count++] = n;
    for (int n = 0; n < count; n++) {
        int parts = part_cut(&front->at[left[n]], cut);
        for (int k = 0; k < parts; k++)
            area_foresee_part(walk, &cut[k], next);
    }
}

/* What is seen of the part, point by point; its corners and what is foreseen
 * are known. */
static rgb area_part_seen(struct area_walk *walk, const struct area_part *part)
{
    struct area_part cut[4];
    rgb sum = rgb_grey(0);
    if (!part_surely_cut(walk, part) && walk->tells(walk, part, &sum))
        return sum;
    int count = part_cut(part, cut);
    sum = rgb_grey(0);
    for (int k = 0; k < count; k++)
        sum = rgb_add(sum, area_part_seen(walk, &cut[k]));
    return rgb_scale(sum, 1.0 / count);
}

/* What is seen of it, many points at a time: level by level, since what is seen
 * decides what is next. */
static rgb area_fronts_seen(struct area_walk *walk,
                            const struct area_part *part)
{
    struct area_front fronts[2], *now = &fronts[0], *next = &fronts[1];
    rgb sum = rgb_grey(0);
    now->count = 0;
    now->full = next->full = false;
    area_foresee_part(walk, part, now);
    area_flush(walk);
    while (now->count > 0 && (!walk->same || walk->closely)) {
        next->count = 0;
        front_tell(walk, now, next, &sum);
        area_flush(walk);
        struct area_front *done = now;
        now = next;
        next = done;
    }
    if (walk->same)
        return rgb_scale(walk->first, part->weight);
    if (now->full || next->full)
        return rgb_scale(area_part_seen(walk, part), part->weight);
    return sum;
}

/* A part of so many points that they have no places all is cut first, if it
 * surely is. */
static rgb area_seen(struct area_walk *walk, const struct area_part *part)
{
    int64_t points =
        (int64_t)(part->i1 - part->i0 + 1) * (part->j1 - part->j0 + 1);
    struct area_part cut[4];
    if (points <= AREA_PLACES || part->level >= walk->surely)
        return area_fronts_seen(walk, part);
    int count = part_cut(part, cut);
    rgb sum = rgb_grey(0);
    for (int k = 0; k < count; k++)
        sum = rgb_add(sum, area_seen(walk, &cut[k]));
    return sum;
}

static bool corners_tell(struct area_walk *walk, const struct area_part *part,
                         rgb *share)
{
    struct area_corners at = area_corners(walk, part);
    if (!part_is_smallest(part) && !corners_agree(walk, &at))
        return false;
    *share = corners_mean(&at);
    return true;
}

static struct area_part area_all(const struct area_grid *grid)
{
    return (struct area_part){ 0, grid->size1 - 1, 0, grid->size2 - 1, 0, 1 };
}

rgb area_visibility(const struct area_grid *grid, rgb arriving,
                    area_visit *visit, void *context)
{
    const struct area_part all = area_all(grid);
    struct area_walk walk;
    area_walk_start(&walk, grid, arriving, visit, context);
    walk.tells = corners_tell;
    walk.closely = false;
    walk.surely = grid->adaptive < 0 ? INT_MAX : grid->adaptive;
    return area_seen(&walk, &all);
}

/* Whether something that lets light pass is before it. */
static bool seen_through(rgb seen)
{
    double least = fmin(fmin(seen.r, seen.g), seen.b);
    return least < 1 && rgb_peak(seen) > 0;
}

/* How much two differ at most. */
static double rgb_apart(rgb a, rgb b)
{
    return fmax(fabs(a.r - b.r), fmax(fabs(a.g - b.g), fabs(a.b - b.b)));
}

/* Whether it is like the first of two that differ. Behind panes light changes
 * by and by as well: then that it is nearer to it. */
static bool edge_like(const struct area_walk *walk, rgb seen, rgb first,
                      rgb last)
{
    return seen_through(first) && seen_through(last)
               ? rgb_apart(seen, first) < rgb_apart(seen, last)
               : area_agree(walk, first, seen);
}

/* How far from one end of an edge to the other the light changes, 0..1. */
static double edge_cut(struct area_walk *walk, int i0, int j0, int i1, int j1)
{
    const rgb first = area_see(walk, i0, j0), last = area_see(walk, i1, j1);
    int steps = abs(i1 - i0) + abs(j1 - j0), low = 0, high = steps;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        rgb seen = area_see(walk, i0 + (i1 - i0) * middle / steps,
                            j0 + (j1 - j0) * middle / steps);
        if (edge_like(walk, seen, first, last))
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
                       const struct area_part *part)
{
    const struct area_ring ring = {
        { part->i0, part->i1, part->i1, part->i0 },
        { part->j0, part->j0, part->j1, part->j1 },
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

/* How often the light is cut each way so that it is looked at from no fewer
 * places than its author has written. */
static int outline_asked(const struct area_grid *grid)
{
    const struct light *light = grid->light;
    int size = light->size1 > light->size2 ? light->size1 : light->size2;
    int cuts = outline_cuts(grid->adaptive), asked = 1;
    if (grid->adaptive >= 0)
        return cuts - (grid->adaptive < cuts);
    while (asked < cuts && 1 << asked < size - 1)
        asked++;
    return asked;
}

/* Dark parts are looked at as closely as the author asks, for there may be gaps
 * in what hides them; lit ones more closely where it costs little. */
static int outline_least(const struct area_walk *walk, rgb seen)
{
    bool lit = rgb_peak(seen) > 0;
    return lit ? walk->surely + walk->thorough : walk->asked;
}

/* Whether it is all behind one pane, as far as its corners tell, and, where
 * they differ, its middle: an outline leaves that like one of them. */
static bool part_seen_through(struct area_walk *walk,
                              const struct area_part *part,
                              const struct area_corners *at)
{
    if (!seen_through(at->a) || !seen_through(at->b) || !seen_through(at->c) ||
        !seen_through(at->d))
        return false;
    const double most =
        fmax(fmax(rgb_apart(at->a, at->b), rgb_apart(at->a, at->c)),
             fmax(rgb_apart(at->b, at->d), rgb_apart(at->c, at->d)));
    if (most < pane_even)
        return true;
    const rgb middle =
        area_see(walk, (part->i0 + part->i1) / 2, (part->j0 + part->j1) / 2);
    return rgb_apart(middle, corners_mean(at)) < pane_even / 2;
}

static bool outline_tells(struct area_walk *walk, const struct area_part *part,
                          rgb *share)
{
    struct area_corners at = area_corners(walk, part);
    bool agree = corners_agree(walk, &at);
    bool last = part->level >= outline_cuts(walk->grid->adaptive);
    if (agree && (last || part->level >= outline_least(walk, at.a)))
        *share = corners_mean(&at);
    else if (part->level >= walk->asked && part_seen_through(walk, part, &at))
        *share = corners_mean(&at);
    else if (last)
        *share = outline_cut(walk, &at, part);
    else
        return false;
    return true;
}

rgb area_outline(const struct area_grid *grid, rgb arriving, bool thorough,
                 area_visit *visit, void *context)
{
    const struct area_part all = area_all(grid);
    struct area_walk walk;
    area_walk_start(&walk, grid, arriving, visit, context);
    walk.closely = true;
    walk.thorough = thorough;
    walk.tells = outline_tells;
    walk.asked = outline_asked(grid);
    walk.surely = outline_cuts(grid->adaptive) - 1;
    if (walk.surely > walk.asked)
        walk.surely = walk.asked;
    return area_fronts_seen(&walk, &all);
}
