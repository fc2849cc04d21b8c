/* Heights on a grid of squares, each cut into two triangles, and what meets
 * them: rays, cells, points. The least and the greatest height of blocks of
 * squares, then of blocks of blocks, tell what is above or below them all:
 * Tevs, Ihrke and Seidel, Maximum Mipmaps for Fast, Accurate, and Scalable
 * Dynamic Height Field Rendering, 2008. Two bytes a height, and 1.4 more.
 *
 * The grid's own space: column and row, of which the first are 0, and heights
 * from 0 to 65535. Square (i, j) is between the columns i and i + 1 and the
 * rows j and j + 1; its diagonal goes from (i, j) to (i + 1, j + 1). */
#ifndef SCENE_HEIGHT_GRID_H
#define SCENE_HEIGHT_GRID_H

#include <stdint.h>
#include <string.h>

#include "base/arena.h"
#include "scene/cell.h"
#include "scene/ray.h"
#include "scene/slab.h"

enum {
    HEIGHT_GRID_LIMIT = 1 << 28, /* heights */
    HEIGHT_GRID_LEVELS = 30,     /* more than log2 of that */
};

struct height_range {
    uint16_t low, high;
};

/* Of level k are blocks of 2^k squares by 2^k. */
struct height_level {
    int columns, rows;
    struct height_range *blocks;
};

struct height_grid {
    int width, height; /* points, at least 2 by 2 */
    uint16_t *heights; /* row by row */
    double water;      /* triangles are where they are not lower */
    struct height_level levels[HEIGHT_GRID_LEVELS]; /* of 0 only the size */
    int top;                                        /* level of one block */
};

/* One of a square's two triangles: over (u, v) in the square the height is
 * base + u slope_u + v slope_v. The right one is where u >= v. */
struct height_plane {
    double base, slope_u, slope_v;
};

/* Fills in the levels, in `arena`; the heights must outlive them. */
void height_grid_prepare(struct height_grid *grid, struct arena *arena);

/* Bytes that the levels of so many heights take at most. */
size_t height_grid_size(int width, int height);

struct height_range height_grid_range(const struct height_grid *grid);

/* Of the block (i, j) of that level. */
static inline struct height_range
height_block_range(const struct height_grid *grid, int level, int i, int j)
{
    const struct height_level *all = &grid->levels[level];
    if (level > 0)
        return all->blocks[(size_t)j * (size_t)all->columns + (size_t)i];
    const uint16_t *h =
        grid->heights + (size_t)j * (size_t)grid->width + (size_t)i;
    const uint16_t *g = h + grid->width;
    struct height_range a = { h[0] < h[1] ? h[0] : h[1],
                              h[0] > h[1] ? h[0] : h[1] };
    struct height_range b = { g[0] < g[1] ? g[0] : g[1],
                              g[0] > g[1] ? g[0] : g[1] };
    return (struct height_range){ a.low < b.low ? a.low : b.low,
                                  a.high > b.high ? a.high : b.high };
}

static inline double height_grid_at(const struct height_grid *grid, int i,
                                    int j)
{
    return grid->heights[(size_t)j * (size_t)grid->width + (size_t)i];
}

/* The part of [*from, *to] of a ray that is between two planes across one of
 * its axes; of a ray along them all or nothing. */
static inline void height_clip(double low, double high, double origin,
                               double direction, double *from, double *to)
{
    double enter = *from, leave = *to;
    double inside = ((origin >= low) & (origin <= high)) ? *to : -HUGE_VAL;
    slab_clip(low, high, origin, 1 / direction, &enter, &leave);
    *from = direction == 0 ? *from : enter;
    *to = direction == 0 ? inside : leave;
}

/* The level of the least blocks that are no narrower than `way` squares, `top`
 * at most. */
static inline int height_level_of(double way, int top)
{
    uint64_t bits;
    memcpy(&bits, &way, sizeof bits);
    int level = (int)(bits >> 52) - 1023 + (bits << 12 != 0);
    level = way > 1 ? level : 0;
    return level < top ? level : top;
}

/* The number of the square that is at `place`: of `size` from `first` on, and
 * none beyond the last. */
static inline int height_square_at(double place, int first, int size, int last)
{
    int most = first + size - 1;
    double low = (double)first, high = (double)(most < last ? most : last);
    double inner = place < high ? place : high;
    return (int)(inner < low ? low : inner);
}

struct height_plane height_grid_plane(const struct height_grid *grid, int i,
                                      int j, bool right);

/* The triangle of a hit, from its `part`. */
struct height_plane height_grid_part(const struct height_grid *grid, int part,
                                     int *i, int *j);

/* Calls visit for the crossings of the ray (x: columns, y: heights, z: rows)
 * with the triangles at t in (tmin, tmax), by increasing t, until it returns
 * true. Where the surface goes on from square to square, so does the count:
 * none is lost or told twice. */
void height_grid_crossings(const struct height_grid *grid,
                           const struct ray *ray, double tmin, double tmax,
                           hit_visit *visit, void *context);

/* The surface's height over a point of the grid; false if there is none. */
bool height_grid_over(const struct height_grid *grid, double x, double z,
                      double *height);

/* Calls visit for every square whose heights and place may meet the box, until
 * it returns true; returns whether it did. */
typedef bool height_visit(void *context, int i, int j);
bool height_grid_search(const struct height_grid *grid, struct box3 box,
                        height_visit *visit, void *context);

#endif
