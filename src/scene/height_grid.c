/* Blocks of heights: see height_grid.h. */
#include "scene/height_grid.h"

#include "base/clones.h"

static int level_count(int width, int height)
{
    int squares = (width > height ? width : height) - 1, top = 0;
    while (squares > 1 << top)
        top++;
    return top;
}

static int level_side(int points, int level)
{
    return (int)(((int64_t)points - 2 + (1 << level)) >> level);
}

size_t height_grid_size(int width, int height)
{
    size_t blocks = 0;
    for (int k = level_count(width, height); k > 0; k--)
        blocks += (size_t)level_side(width, k) * (size_t)level_side(height, k);
    return blocks * sizeof(struct height_range);
}

static struct height_range range_join(struct height_range a,
                                      struct height_range b)
{
    return (struct height_range){ a.low < b.low ? a.low : b.low,
                                  a.high > b.high ? a.high : b.high };
}

/* So many blocks' ranges are found at a time. */
enum { RANGES = 256, RANGE_POINTS = 2 * RANGES + 1 };

INLINED uint16_t lower(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

INLINED uint16_t higher(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

/* The ranges of `count` blocks of 2 x 2 squares below three rows of points.
 * Points that are no longer in the grid are those at its edge once more. */
CLONES static void ranges_of_points(const uint16_t *const rows[3], int points,
                                    struct height_range *restrict ranges,
                                    int count)
{
    uint16_t low[RANGE_POINTS], high[RANGE_POINTS];
    const uint16_t *a = rows[0], *b = rows[1], *c = rows[2];
    for (int i = 0; i < points; i++) {
        low[i] = lower(lower(a[i], b[i]), c[i]);
        high[i] = higher(higher(a[i], b[i]), c[i]);
    }
    for (int i = points; i < 2 * count + 1; i++) {
        low[i] = low[points - 1];
        high[i] = high[points - 1];
    }
    for (int k = 0; k < count; k++) {
        ranges[k].low =
            lower(lower(low[2 * k], low[2 * k + 1]), low[2 * k + 2]);
        ranges[k].high =
            higher(higher(high[2 * k], high[2 * k + 1]), high[2 * k + 2]);
    }
}

/* A row of blocks of 2 x 2 squares. */
static void row_of_points(const struct height_grid *grid, int row,
                          struct height_range *ranges, int count)
{
    for (int k = 0; k < count; k += RANGES) {
        const uint16_t *rows[3];
        int some = count - k < RANGES ? count - k : RANGES;
        int points = grid->width - 2 * k < 2 * some + 1 ? grid->width - 2 * k
                                                        : 2 * some + 1;
        for (int i = 0; i < 3; i++) {
            int y = 2 * row + i < grid->height ? 2 * row + i : grid->height - 1;
            rows[i] = grid->heights + (size_t)y * (size_t)grid->width + 2 * k;
        }
        ranges_of_points(rows, points, ranges + k, some);
    }
}

static struct height_range range_of_blocks(const struct height_level *below,
                                           int column, int row)
{
    struct height_range range = { UINT16_MAX, 0 };
    for (int j = 2 * row; j <= 2 * row + 1 && j < below->rows; j++) {
        for (int i = 2 * column; i <= 2 * column + 1 && i < below->columns; i++)
            range = range_join(
                range,
                below->blocks[(size_t)j * (size_t)below->columns + (size_t)i]);
    }
    return range;
}

void height_grid_prepare(struct height_grid *grid, struct arena *arena)
{
    grid->top = level_count(grid->width, grid->height);
    for (int k = 0; k <= grid->top; k++) {
        struct height_level *level = &grid->levels[k];
        level->columns = level_side(grid->width, k);
        level->rows = level_side(grid->height, k);
        if (k == 0)
            continue;
        size_t columns = (size_t)level->columns;
        level->blocks = ARENA_ARRAY(arena, struct height_range,
                                    columns * (size_t)level->rows);
        for (int j = 0; j < level->rows; j++) {
            struct height_range *row = level->blocks + (size_t)j * columns;
            if (k == 1)
                row_of_points(grid, j, row, level->columns);
            else
                for (int i = 0; i < level->columns; i++)
                    row[i] = range_of_blocks(level - 1, i, j);
        }
    }
}

struct height_range height_grid_range(const struct height_grid *grid)
{
    return height_block_range(grid, grid->top, 0, 0);
}

struct height_plane height_grid_plane(const struct height_grid *grid, int i,
                                      int j, bool right)
{
    const uint16_t *h =
        grid->heights + (size_t)j * (size_t)grid->width + (size_t)i;
    const uint16_t *g = h + grid->width;
    double a = h[0], d = g[1], corner = right ? h[1] : g[0];
    if (right)
        return (struct height_plane){ a, corner - a, d - corner };
    return (struct height_plane){ a, d - corner, corner - a };
}

static int part_of(const struct height_grid *grid, int i, int j, bool right)
{
    return 2 * (j * (grid->width - 1) + i) + right;
}

struct height_plane height_grid_part(const struct height_grid *grid, int part,
                                     int *i, int *j)
{
    int square = part / 2;
    *i = square % (grid->width - 1);
    *j = square / (grid->width - 1);
    return height_grid_plane(grid, *i, *j, part % 2);
}

bool height_grid_over(const struct height_grid *grid, double x, double z,
                      double *height)
{
    if (!(x >= 0 && z >= 0 && x <= grid->width - 1 && z <= grid->height - 1))
        return false;
    int i = (int)fmin(x, grid->width - 2), j = (int)fmin(z, grid->height - 2);
    double u = x - i, v = z - j;
    struct height_plane plane = height_grid_plane(grid, i, j, u >= v);
    *height = plane.base + u * plane.slope_u + v * plane.slope_v;
    return *height >= grid->water;
}

/* ---- rays ---- */

/* Where a ray is on its way over the squares, block by block: up a level where
 * it leaves the block of that level, down where it may meet what is in one. */
struct height_place {
    double from, to; /* of the ray, over the block at hand */
    int level, i, j; /* the square at `from`; its block of this level */
    int side; /* of the surface, where the ray is: 1 above, -1 below, 0 not
               * known */
};

struct height_walk {
    const struct height_grid *grid;
    vec3 origin, direction;
    double inverse_x, inverse_z; /* 0: it goes along the rows or columns */
    double doubt;                /* how far heights along the ray may be off */
    double tmin, tmax;
    double end;
    hit_visit *visit;
    void *context;
};

/* Over one triangle; the ray is on the side that it came to its edge on. */
static bool walk_triangle(const struct height_walk *w,
                          struct height_place *place, bool right, double from,
                          double to)
{
    const struct height_plane p =
        height_grid_plane(w->grid, place->i, place->j, right);
    vec3 o = w->origin, d = w->direction;
    double u = o.x - place->i, v = o.z - place->j;
    double above = o.y - p.base - p.slope_u * u - p.slope_v * v;
    double rate = d.y - p.slope_u * d.x - p.slope_v * d.z;
    if (place->side == 0)
        place->side = above + rate * from > 0 ? 1 : -1;
    int after = above + rate * to > 0 ? 1 : -1;
    if (after == place->side)
        return false;
    place->side = after;
    double t = -above / rate;
    t = t < from ? from : t > to ? to : t;
    double height =
        p.base + p.slope_u * (u + d.x * t) + p.slope_v * (v + d.z * t);
    if (!(t > w->tmin && t < w->tmax && height >= w->grid->water))
        return false;
    struct hit hit = { t, part_of(w->grid, place->i, place->j, right), 0, 0 };
    return w->visit(w->context, &hit);
}

static bool walk_square(const struct height_walk *w, struct height_place *place)
{
    double lead = (w->origin.x - place->i) - (w->origin.z - place->j);
    double rate = w->direction.x - w->direction.z;
    double when = rate != 0 ? -lead / rate : HUGE_VAL;
    bool right = rate > 0   ? place->from >= when
                 : rate < 0 ? place->from < when
                            : lead >= 0;
    if (!(when > place->from && when < place->to))
        return walk_triangle(w, place, right, place->from, place->to);
    return walk_triangle(w, place, right, place->from, when) ||
           walk_triangle(w, place, !right, when, place->to);
}

/* Whether all of the block is on one side of the ray, or under water. */
INLINED bool walk_passes(const struct height_walk *w,
                         struct height_place *place)
{
    struct height_range range =
        height_block_range(w->grid, place->level, place->i >> place->level,
                           place->j >> place->level);
    double a = w->origin.y + w->direction.y * place->from;
    double b = w->origin.y + w->direction.y * place->to;
    double low = range.low - w->doubt, high = range.high + w->doubt;
    if (a > high && b > high)
        place->side = 1;
    else if (a < low && b < low)
        place->side = -1;
    else if (range.high < w->grid->water)
        place->side = 0;
    else
        return false;
    return true;
}

/* Where the ray leaves the block at hand; infinite along it. */
INLINED double block_end(int at, int level, double origin, double inverse)
{
    int edge = ((at >> level) + (inverse > 0)) << level;
    return inverse != 0 ? (edge - origin) * inverse : HUGE_VAL;
}

/* To the next block, of the largest size that begins there: without branches,
 * for which way a ray goes on nobody foretells. False: that was the last one.
 */
INLINED bool walk_on(const struct height_walk *w, struct height_place *place,
                     bool along_x)
{
    const struct height_level *squares = w->grid->levels;
    const int level = place->level;
    const int at = along_x ? place->i : place->j;
    const int beside = along_x ? place->j : place->i;
    const int count = along_x ? squares->columns : squares->rows;
    const int last = (along_x ? squares->rows : squares->columns) - 1;
    const double origin = along_x ? w->origin.z : w->origin.x;
    const double direction = along_x ? w->direction.z : w->direction.x;
    const int up = (along_x ? w->inverse_x : w->inverse_z) > 0;
    const int next = (((at >> level) + up) << level) - !up;
    if (place->to >= w->end || (unsigned)next >= (unsigned)count)
        return false;
    place->from = place->to;
    const int there =
        height_square_at(origin + direction * place->from,
                         beside >> level << level, 1 << level, last);
    place->i = along_x ? next : there;
    place->j = along_x ? there : next;
    /* Into a block whose parent is another one. */
    place->level += (up ^ (next >> level & 1)) & (level < w->grid->top);
    return true;
}

static void walk_grid(const struct height_walk *w, struct height_place start)
{
    struct height_place at = start;
    for (;;) {
        double end_x = block_end(at.i, at.level, w->origin.x, w->inverse_x);
        double end_z = block_end(at.j, at.level, w->origin.z, w->inverse_z);
        double to = end_x < end_z ? end_x : end_z;
        at.to = to < w->end ? to : w->end;
        if (!walk_passes(w, &at)) {
            if (at.level > 0) {
                at.level--;
                continue;
            }
            struct height_place square = at;
            if (walk_square(w, &square))
                return;
            at.side = square.side;
        }
        if (!walk_on(w, &at, end_x <= end_z))
            return;
    }
}

/* The level to begin with: that of blocks half of which the ray may pass over
 * on its way down or up. What begins on the surface is near it. */
static int first_level(const struct height_grid *grid, vec3 direction,
                       double from, double to, double tmin)
{
    double x = fabs(direction.x), z = fabs(direction.z);
    double way = 0.5 * (x > z ? x : z) * (to - from);
    return from > tmin ? height_level_of(way, grid->top) : 0;
}

void height_grid_crossings(const struct height_grid *grid,
                           const struct ray *ray, double tmin, double tmax,
                           hit_visit *visit, void *context)
{
    vec3 o = ray->origin, d = ray->direction;
    struct height_range range = height_grid_range(grid);
    double from = tmin, to = tmax;
    height_clip(0, grid->width - 1, o.x, d.x, &from, &to);
    height_clip(0, grid->height - 1, o.z, d.z, &from, &to);
    height_clip(range.low - 1.0, range.high + 1.0, o.y, d.y, &from, &to);
    if (!(from < to) || !isfinite(from) || !isfinite(to))
        return;
    struct height_walk walk = { .grid = grid,
                                .origin = o,
                                .direction = d,
                                .inverse_x = d.x != 0 ? 1 / d.x : 0,
                                .inverse_z = d.z != 0 ? 1 / d.z : 0,
                                .tmin = tmin,
                                .tmax = tmax,
                                .end = to,
                                .visit = visit,
                                .context = context };
    double far = -from > to ? -from : to;
    walk.doubt = 1e-6 + 1e-12 * (fabs(o.y) + fabs(d.y) * far);
    walk_grid(&walk,
              (struct height_place){
                  .from = from,
                  .level = first_level(grid, d, from, to, tmin),
                  .i = height_square_at(o.x + d.x * from, 0, 1 << grid->top,
                                        grid->width - 2),
                  .j = height_square_at(o.z + d.z * from, 0, 1 << grid->top,
                                        grid->height - 2) });
}

/* ---- boxes ---- */

struct block {
    int level, i, j;
};

static bool block_meets(const struct height_grid *grid, struct block b,
                        const struct box3 *box)
{
    double size = ldexp(1, b.level), x = b.i * size, z = b.j * size;
    if (box->low.x > x + size || box->high.x < x || box->low.z > z + size ||
        box->high.z < z)
        return false;
    struct height_range range = height_block_range(grid, b.level, b.i, b.j);
    return box->low.y <= range.high && box->high.y >= range.low &&
           range.high >= grid->water && box->high.y >= grid->water;
}

bool height_grid_search(const struct height_grid *grid, struct box3 box,
                        height_visit *visit, void *context)
{
    struct block stack[4 * HEIGHT_GRID_LEVELS] = { { grid->top, 0, 0 } };
    int depth = 1;
    while (depth > 0) {
        struct block b = stack[--depth];
        if (!block_meets(grid, b, &box))
            continue;
        if (b.level == 0 && visit(context, b.i, b.j))
            return true;
        for (int k = 0; k < 4 && b.level > 0; k++) {
            const struct height_level *below = &grid->levels[b.level - 1];
            struct block part = { b.level - 1, 2 * b.i + (k & 1),
                                  2 * b.j + (k >> 1) };
            if (part.i < below->columns && part.j < below->rows)
                stack[depth++] = part;
        }
    }
    return false;
}
