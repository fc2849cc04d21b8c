/* Bright places: see bright.h. */
#include "lightmesh/bright.h"

#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/tuning.h"

enum { CELLS_MOST = 1 << 30 }; /* from the origin */

/* Hits in one cell, of sides that are twice as long for each level. */
struct cell {
    int at[3];
    int level;
    int count;
    double light; /* their sum */
};

static int cell_order(const void *a, const void *b)
{
    const struct cell *x = a, *y = b;
    for (int axis = 0; axis < 3; axis++)
        if (x->at[axis] != y->at[axis])
            return x->at[axis] < y->at[axis] ? -1 : 1;
    return (x->light > y->light) - (x->light < y->light);
}

/* What sends most comes first; the order of cells decides where they are
 * alike. */
static int cell_brighter(const void *a, const void *b)
{
    const struct cell *x = a, *y = b;
    return x->light != y->light ? (x->light < y->light) - (x->light > y->light)
                                : cell_order(a, b);
}

static int number_order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The box around most of them: what is seen through a window does not make the
 * room larger. */
struct box {
    double low[3], high[3];
};

static void box_along(struct box *box, const struct bright_hit *hits,
                      size_t count, int axis, double *sorted)
{
    size_t outside = (size_t)(bright_outside * (double)count);
    for (size_t i = 0; i < count; i++)
        sorted[i] = vec3_component(hits[i].place, axis);
    qsort(sorted, count, sizeof *sorted, number_order);
    box->low[axis] = sorted[outside];
    box->high[axis] = sorted[count - 1 - outside];
}

static struct box box_around(const struct bright_hit *hits, size_t count)
{
    double *sorted = memory_new(count * sizeof *sorted);
    struct box box;
    for (int axis = 0; axis < 3; axis++)
        box_along(&box, hits, count, axis, sorted);
    memory_free(sorted);
    return box;
}

/* Where the hit is seen: beyond the box, where the way there leaves it. */
static vec3 box_place(const struct box *box, const struct bright_hit *hit)
{
    vec3 way = vec3_sub(hit->place, hit->from);
    double part = 1;
    for (int axis = 0; axis < 3; axis++) {
        double along = vec3_component(way, axis);
        double wall = along > 0 ? box->high[axis] : box->low[axis];
        double from = vec3_component(hit->from, axis);
        if ((wall - from) * along > 0)
            part = fmin(part, (wall - from) / along);
    }
    return vec3_along(hit->from, way, part);
}

static double box_size(const struct box *box)
{
    double size = 0;
    for (int axis = 0; axis < 3; axis++)
        size = fmax(size, box->high[axis] - box->low[axis]);
    return size;
}

/* Of a coordinate in sides; what is too far off to be told apart is one. */
static int cell_at(double coordinate)
{
    return (int)floor(fmin(fmax(coordinate, -CELLS_MOST), CELLS_MOST));
}

/* One cell for each hit. */
static void cells_take(struct cell *cells, const struct bright_hit *hits,
                       size_t count, const struct box *box, double side)
{
    for (size_t i = 0; i < count; i++) {
        vec3 at = vec3_scale(box_place(box, &hits[i]), 1 / side);
        cells[i] = (struct cell){
            { cell_at(at.x), cell_at(at.y), cell_at(at.z) }, 0, 1, hits[i].light
        };
    }
}

/* Those at one place are joined; returns how many are left. */
static size_t cells_join(struct cell *cells, size_t count)
{
    size_t joined = 0;
    qsort(cells, count, sizeof *cells, cell_order);
    for (size_t i = 0; i < count; i++) {
        struct cell *last = &cells[joined - (joined > 0)];
        bool same = joined > 0 && last->at[0] == cells[i].at[0] &&
                    last->at[1] == cells[i].at[1] &&
                    last->at[2] == cells[i].at[2];
        if (!same) {
            cells[joined++] = cells[i];
            continue;
        }
        last->count += cells[i].count;
        last->light += cells[i].light;
    }
    return joined;
}

/* Those that have hits enough come first; returns how many. */
static size_t cells_enough(struct cell *cells, size_t count)
{
    size_t enough = 0;
    for (size_t i = 0; i < count; i++) {
        struct cell cell = cells[i];
        if (cell.count < BRIGHT_HITS)
            continue;
        cells[i] = cells[enough];
        cells[enough++] = cell;
    }
    return enough;
}

/* A few hits don't tell how bright it is around them: those are joined with
 * their neighbours' to cells twice as large, and so on. */
static size_t cells_grow(struct cell *cells, size_t count)
{
    size_t done = 0;
    for (int level = 0;; level++) {
        count = done + cells_join(cells + done, count - done);
        if (level == BRIGHT_LEVELS)
            return count;
        done += cells_enough(cells + done, count - done);
        for (size_t i = done; i < count; i++) {
            cells[i].level++;
            for (int axis = 0; axis < 3; axis++)
                cells[i].at[axis] = (int)floor((double)cells[i].at[axis] / 2);
        }
    }
}

static void bright_add(struct bright *bright, const struct cell *cell,
                       double side)
{
    int i = bright->count++;
    double size = ldexp(side, cell->level);
    bright->at[i].light = cell->light / cell->count;
    bright->at[i].radius = size * bright_ball;
    bright->at[i].centre = vec3_scale(
        vec3_make(cell->at[0] + 0.5, cell->at[1] + 0.5, cell->at[2] + 0.5),
        size);
}

/* What is brighter by far than others. */
static void bright_choose(struct bright *bright, struct cell *cells,
                          size_t count, double side)
{
    double total = 0, hits = 0;
    for (size_t i = 0; i < count; i++) {
        total += cells[i].light;
        hits += cells[i].count;
    }
    qsort(cells, count, sizeof *cells, cell_brighter);
    for (size_t i = 0; i < count && bright->count < BRIGHT_MOST; i++)
        if (cells[i].light * hits > bright_times * total * cells[i].count)
            bright_add(bright, &cells[i], side);
}

struct bright bright_of(const struct bright_hit *hits, size_t count)
{
    struct bright bright = { .count = 0 };
    if (count == 0)
        return bright;
    struct box box = box_around(hits, count);
    double side = exp2(floor(log2(box_size(&box) / bright_cells)));
    if (!(side > 0))
        return bright;
    struct cell *cells = memory_new(count * sizeof *cells);
    cells_take(cells, hits, count, &box, side);
    bright_choose(&bright, cells, cells_grow(cells, count), side);
    memory_free(cells);
    return bright;
}

void bright_learn(struct bright *bright, const struct bright_found *found)
{
    int kept = 0;
    for (int i = 0; i < bright->count; i++) {
        if (found->rays[i] >= BRIGHT_HITS)
            bright->at[i].light = found->light[i] / found->rays[i];
        if (bright->at[i].light > 0)
            bright->at[kept++] = bright->at[i];
    }
    bright->count = kept;
}

void aim_take(struct aim *aim, const struct bright *bright, vec3 place)
{
    double sum = 0;
    aim->count = bright->count;
    for (int i = 0; i < aim->count; i++) {
        vec3 offset = vec3_sub(bright->at[i].centre, place);
        double distance = vec3_length(offset),
               sine = bright->at[i].radius / distance;
        bool within = !(sine < 1);
        double rise = within ? 2 : 1 - sqrt(1 - sine * sine);
        aim->cone[i].axis =
            within ? vec3_make(0, 0, 1) : vec3_scale(offset, 1 / distance);
        aim->cone[i].rise = rise;
        aim->cone[i].share = bright->at[i].light * rise;
        aim->sums[i] = sum += aim->cone[i].share;
    }
    for (int i = 0; i < aim->count; i++)
        aim->cone[i].share /= sum;
}

vec3 aim_way(const struct aim *aim, const double u[2], int *which)
{
    double share, sum = aim->sums[aim->count - 1];
    size_t i = draw_share(aim->sums, (size_t)aim->count, u[0], &share);
    double before = i > 0 ? aim->sums[i - 1] / sum : 0;
    double within[2] = { fmin(fmax((u[0] - before) / share, 0), 1), u[1] };
    *which = (int)i;
    return warp_cone(within, aim->cone[i].axis, aim->cone[i].rise);
}

double aim_density(const struct aim *aim, vec3 way)
{
    double density = 0;
    for (int i = 0; i < aim->count; i++)
        if (1 - vec3_dot(way, aim->cone[i].axis) <= aim->cone[i].rise)
            density +=
                aim->cone[i].share * warp_cone_density(aim->cone[i].rise);
    return density;
}
