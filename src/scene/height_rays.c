/* Rays side by side over a grid of heights, each as height_grid_crossings walks
 * it, to the bit. Each step takes some of them to their next blocks, or down a
 * level, or lets those that may meet something in a square look there: half of
 * the lanes at a time, for many packets have no more rays, and of others some
 * walk on for long after the rest. */
#include "scene/height_rays.h"

#include <string.h>

enum { WALKS = LANE_STEP };

/* So many of them, with the numbers of height_walk and height_place. */
struct walks {
    LANE_LINES double origin[3][WALKS], direction[3][WALKS];
    double tmin[WALKS], tmax[WALKS];
    double inverse_x[WALKS], inverse_z[WALKS], doubt[WALKS];
    double from[WALKS], to[WALKS], end[WALKS];
    double end_x[WALKS], end_z[WALKS];
    double low[WALKS], high[WALKS];   /* of the blocks at hand, */
    double corner[4][WALKS];          /* or of the squares: (0,0), (1,0),
                                       * (0,1), (1,1) */
    double side[WALKS];               /* 1, -1 or 0 */
    double column[WALKS], row[WALKS]; /* the square at hand */
    double t[WALKS], right[WALKS];    /* what is met */
    int32_t level[WALKS], i[WALKS], j[WALKS];
    int first; /* number of the first ray among all */
};

/* What there is to walk over. */
struct walks_grid {
    double wide, deep; /* squares */
    double low, high;  /* of all heights, with room */
    int32_t last_i, last_j, top;
};

/* ---- the beginning ---- */

CLONES static void walks_clip(struct walks *restrict w,
                              const struct walks_grid *restrict grid,
                              double *restrict way, int32_t *restrict any)
{
    const struct walks_grid g = *grid;
    for (int k = 0; k < WALKS; k++) {
        double x = w->direction[0][k], z = w->direction[2][k];
        double y = w->direction[1][k];
        double from = w->tmin[k], to = w->tmax[k];
        height_clip(0, g.wide, w->origin[0][k], x, &from, &to);
        height_clip(0, g.deep, w->origin[2][k], z, &from, &to);
        height_clip(g.low, g.high, w->origin[1][k], y, &from, &to);
        double size = fabs(x) > fabs(z) ? fabs(x) : fabs(z);
        double far = -from > to ? -from : to;
        w->inverse_x[k] = x != 0 ? 1 / x : 0;
        w->inverse_z[k] = z != 0 ? 1 / z : 0;
        w->doubt[k] = 1e-6 + 1e-12 * (fabs(w->origin[1][k]) + fabs(y) * far);
        way[k] = from > w->tmin[k] ? 0.5 * size * (to - from) : 0;
        any[k] = -((from < to) & (from - from == 0) & (to - to == 0));
        w->from[k] = from;
        w->end[k] = to;
        w->side[k] = 0;
        w->t[k] = HUGE_VAL;
        w->right[k] = 0;
    }
}

CLONES static void walks_squares_first(struct walks *restrict w,
                                       const struct walks_grid *restrict grid)
{
    const int32_t last_i = grid->last_i, last_j = grid->last_j;
    const int32_t size = (int32_t)1 << grid->top;
    for (int k = 0; k < WALKS; k++) {
        double x = w->origin[0][k] + w->direction[0][k] * w->from[k];
        double z = w->origin[2][k] + w->direction[2][k] * w->from[k];
        w->i[k] = height_square_at(x, 0, size, last_i);
        w->j[k] = height_square_at(z, 0, size, last_j);
    }
}

/* Puts the rays from number `first` on at the beginnings of their walks;
 * returns those that may meet anything. */
static unsigned walks_begin(struct walks *w, const struct walks_grid *grid,
                            const struct rays *rays,
                            const struct rays_span *span, int first)
{
    LANE_LINES double way[WALKS];
    LANE_LINES int32_t any[WALKS];
    w->first = first;
    for (int axis = 0; axis < 3; axis++) {
        memcpy(w->origin[axis], rays->origin[axis] + first,
               sizeof w->origin[axis]);
        memcpy(w->direction[axis], rays->direction[axis] + first,
               sizeof w->direction[axis]);
    }
    memcpy(w->tmin, span->near + first, sizeof w->tmin);
    memcpy(w->tmax, span->far + first, sizeof w->tmax);
    walks_clip(w, grid, way, any);
    walks_squares_first(w, grid);
    for (int k = 0; k < WALKS; k++)
        w->level[k] = any[k] ? height_level_of(way[k], grid->top) : 0;
    return flags_bits(any, WALKS);
}

/* ---- steps ---- */

static void walks_ranges(const struct height_grid *grid, struct walks *w,
                         unsigned lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes), level = w->level[k];
        struct height_range range =
            height_block_range(grid, level, w->i[k] >> level, w->j[k] >> level);
        w->low[k] = range.low;
        w->high[k] = range.high;
    }
}

/* What walk_passes says of each; those that don't pass and are over more than a
 * square go down a level. */
CLONES static void walks_pass(struct walks *restrict w, double water,
                              int32_t *restrict passes,
                              int32_t *restrict square)
{
    for (int k = 0; k < WALKS; k++) {
        double a = w->origin[1][k] + w->direction[1][k] * w->from[k];
        double b = w->origin[1][k] + w->direction[1][k] * w->to[k];
        double low = w->low[k] - w->doubt[k], high = w->high[k] + w->doubt[k];
        double side = w->high[k] < water ? 0 : 2;
        side = ((a > high) & (b > high)) ? 1 : side;
        side = ((a < low) & (b < low)) ? -1 : side;
        int32_t pass = side < 2 ? -1 : 0;
        int32_t one = ~pass & (w->level[k] == 0 ? -1 : 0);
        w->side[k] = side < 2 ? side : w->side[k];
        w->level[k] += ~pass & ~one;
        passes[k] = pass;
        square[k] = one;
    }
}

/* The first square of the next block where an edge of this axis is crossed. */
INLINED int32_t walk_across(int32_t first, int32_t size, int32_t up)
{
    return up ? first + size : first - 1;
}

/* Where each leaves its block. */
CLONES static void walks_ends(struct walks *restrict w)
{
    for (int k = 0; k < WALKS; k++) {
        int32_t level = w->level[k];
        int32_t past_x = w->inverse_x[k] > 0, past_z = w->inverse_z[k] > 0;
        double edge_x = (double)(((w->i[k] >> level) + past_x) << level);
        double edge_z = (double)(((w->j[k] >> level) + past_z) << level);
        double end_x = (edge_x - w->origin[0][k]) * w->inverse_x[k];
        double end_z = (edge_z - w->origin[2][k]) * w->inverse_z[k];
        end_x = w->inverse_x[k] != 0 ? end_x : HUGE_VAL;
        end_z = w->inverse_z[k] != 0 ? end_z : HUGE_VAL;
        double to = end_x < end_z ? end_x : end_z;
        w->end_x[k] = end_x;
        w->end_z[k] = end_z;
        w->to[k] = to < w->end[k] ? to : w->end[k];
    }
}

/* walk_on of those that `moves` are -1 for; `gone`: that was the last block,
 * and they stay. */
CLONES static void walks_on(struct walks *restrict w,
                            const struct walks_grid *restrict grid,
                            const int32_t *restrict moves,
                            int32_t *restrict gone)
{
    const int32_t last_i = grid->last_i, last_j = grid->last_j;
    const int32_t top = grid->top;
    for (int k = 0; k < WALKS; k++) {
        int32_t across = w->end_x[k] <= w->end_z[k] ? -1 : 0;
        int32_t ends = w->to[k] >= w->end[k] ? -1 : 0;
        int32_t up_x = w->inverse_x[k] > 0 ? -1 : 0;
        int32_t up_z = w->inverse_z[k] > 0 ? -1 : 0;
        int32_t level = w->level[k], move = moves[k], size = 1 << level;
        int32_t first_i = w->i[k] >> level << level;
        int32_t first_j = w->j[k] >> level << level;
        double x = w->origin[0][k] + w->direction[0][k] * w->to[k];
        double z = w->origin[2][k] + w->direction[2][k] * w->to[k];
        int32_t beside_i = height_square_at(x, first_i, size, last_i);
        int32_t beside_j = height_square_at(z, first_j, size, last_j);
        int32_t i = across ? walk_across(first_i, size, up_x) : beside_i;
        int32_t j = across ? beside_j : walk_across(first_j, size, up_z);
        int32_t at = across ? i : j, last = across ? last_i : last_j;
        int32_t up = across ? up_x : up_z, odd = -(at >> level & 1);
        int32_t parent = (up ^ odd) & (level < top ? -1 : 0);
        int32_t low = at < 0 ? -1 : 0, high = at > last ? -1 : 0;
        gone[k] = ends | low | high;
        move &= ~gone[k];
        w->i[k] = move ? i : w->i[k];
        w->j[k] = move ? j : w->j[k];
        w->level[k] = level - (parent & move);
        w->from[k] = move ? w->to[k] : w->from[k];
    }
}

/* ---- squares ---- */

static void walks_corners(const struct height_grid *grid, struct walks *w,
                          unsigned lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        const uint16_t *h = grid->heights +
                            (size_t)w->j[k] * (size_t)grid->width +
                            (size_t)w->i[k];
        w->corner[0][k] = h[0];
        w->corner[1][k] = h[1];
        w->corner[2][k] = h[grid->width];
        w->corner[3][k] = h[grid->width + 1];
        w->column[k] = w->i[k];
        w->row[k] = w->j[k];
    }
}

/* A ray over a triangle. */
struct triangle_way {
    double base, slope_u, slope_v; /* as of a height_plane */
    double from, to;
    double side;
};

INLINED struct triangle_way triangle_way(const struct walks *w, int k,
                                         double right)
{
    double a = w->corner[0][k], d = w->corner[3][k];
    double corner = right > 0 ? w->corner[1][k] : w->corner[2][k];
    double fall = corner - a, rise = d - corner;
    return (struct triangle_way){ .base = a,
                                  .slope_u = right > 0 ? fall : rise,
                                  .slope_v = right > 0 ? rise : fall };
}

/* Where walk_triangle finds a crossing; infinite: nowhere. */
INLINED double triangle_meets(const struct walks *w, int k, double water,
                              struct triangle_way *way)
{
    double dx = w->direction[0][k], dz = w->direction[2][k];
    double u = w->origin[0][k] - w->column[k];
    double v = w->origin[2][k] - w->row[k];
    double above =
        w->origin[1][k] - way->base - way->slope_u * u - way->slope_v * v;
    double rate = w->direction[1][k] - way->slope_u * dx - way->slope_v * dz;
    double before = above + rate * way->from > 0 ? 1 : -1;
    double after = above + rate * way->to > 0 ? 1 : -1;
    double side = way->side == 0 ? before : way->side;
    double t = -above / rate;
    t = t > way->to ? way->to : t;
    t = -above / rate < way->from ? way->from : t;
    double height =
        way->base + way->slope_u * (u + dx * t) + way->slope_v * (v + dz * t);
    t = after != side ? t : HUGE_VAL;
    t = t > w->tmin[k] ? t : HUGE_VAL;
    t = t < w->tmax[k] ? t : HUGE_VAL;
    way->side = after;
    return height >= water ? t : HUGE_VAL;
}

/* As walk_square of each; what is met into t and right. */
CLONES static void walks_meet(struct walks *restrict w, double water,
                              const int32_t *restrict square,
                              int32_t *restrict met)
{
    for (int k = 0; k < WALKS; k++) {
        double from = w->from[k], to = w->to[k];
        double lead =
            (w->origin[0][k] - w->column[k]) - (w->origin[2][k] - w->row[k]);
        double rate = w->direction[0][k] - w->direction[2][k];
        double when = rate != 0 ? -lead / rate : HUGE_VAL;
        double later = from >= when ? 1 : 0, sooner = from < when ? 1 : 0;
        double right = lead >= 0 ? 1 : 0;
        right = rate > 0 ? later : right;
        right = rate < 0 ? sooner : right;
        double middle = when > from ? when : to; /* to: there is none */
        middle = middle < to ? middle : to;
        struct triangle_way one = triangle_way(w, k, right);
        one.from = from;
        one.to = middle;
        one.side = w->side[k];
        double first = triangle_meets(w, k, water, &one);
        struct triangle_way other = triangle_way(w, k, 1 - right);
        other.from = middle;
        other.to = to;
        other.side = one.side;
        double second = triangle_meets(w, k, water, &other);
        second = middle < to ? second : HUGE_VAL;
        double side = middle < to ? other.side : one.side;
        w->side[k] = square[k] ? side : w->side[k];
        w->t[k] = first < HUGE_VAL ? first : second;
        w->right[k] = first < HUGE_VAL ? right : 1 - right;
        met[k] = (w->t[k] < HUGE_VAL ? -1 : 0) & square[k];
    }
}

/* ---- all of it ---- */

/* What is met at the square at hand. */
static void walks_take(const struct walks *w, const struct walks_grid *over,
                       unsigned lanes, struct rays_met *met)
{
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes), ray = w->first + k;
        met->t[ray] = w->t[k];
        met->part[ray] =
            2 * (w->row[k] * over->wide + w->column[k]) + w->right[k];
    }
}

/* All look at their squares; returns those that meet something there. */
static unsigned walks_look(const struct height_grid *grid, struct walks *w,
                           unsigned lanes, const int32_t square[WALKS],
                           int32_t moves[WALKS])
{
    LANE_LINES int32_t met[WALKS];
    walks_corners(grid, w, lanes);
    walks_meet(w, grid->water, square, met);
    for (int k = 0; k < WALKS; k++)
        moves[k] |= square[k] & ~met[k];
    return flags_bits(met, WALKS) & lanes;
}

static void walks_go(const struct height_grid *grid,
                     const struct walks_grid *over, struct walks *w,
                     unsigned lanes, struct rays_met *met)
{
    LANE_LINES int32_t moves[WALKS], square[WALKS], gone[WALKS];
    while (lanes) {
        walks_ends(w);
        walks_ranges(grid, w, lanes);
        walks_pass(w, grid->water, moves, square);
        unsigned looking = flags_bits(square, WALKS) & lanes;
        if (looking) {
            unsigned done = walks_look(grid, w, looking, square, moves);
            walks_take(w, over, done, met);
            lanes &= ~done;
        }
        walks_on(w, over, moves, gone);
        lanes &= ~(flags_bits(moves, WALKS) & flags_bits(gone, WALKS));
    }
}

void height_rays_first(const struct height_grid *grid, struct lane_run run,
                       const struct rays *rays, const struct rays_span *span,
                       struct rays_met *met)
{
    const struct height_range range = height_grid_range(grid);
    const struct walks_grid over = {
        .wide = grid->width - 1,
        .deep = grid->height - 1,
        .low = range.low - 1.0,
        .high = range.high + 1.0,
        .last_i = grid->width - 2,
        .last_j = grid->height - 2,
        .top = grid->top,
    };
    struct walks walks;
    for (int i = run.first; i < run.end; i++) {
        met->t[i] = HUGE_VAL;
        met->part[i] = 0;
    }
    for (int first = run.first; first < run.end; first += WALKS) {
        unsigned lanes = walks_begin(&walks, &over, rays, span, first);
        walks_go(grid, &over, &walks, lanes, met);
    }
}
