/* Bright places: see bright.h. */
#include "lightmesh/bright.h"

#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/tuning.h"

/* Hits in one cell. */
struct cell {
    int at[3];
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

/* Brightest first; the order of cells decides where they are alike. */
static int cell_brighter(const void *a, const void *b)
{
    const struct cell *x = a, *y = b;
    return x->light != y->light ? (x->light < y->light) - (x->light > y->light)
                                : cell_order(a, b);
}

/* The longest side of the box around them. */
static double hits_size(const struct bright_hit *hits, size_t count)
{
    vec3 low = hits[0].place, high = low;
    for (size_t i = 1; i < count; i++) {
        vec3 p = hits[i].place;
        low = vec3_make(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high =
            vec3_make(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    vec3 size = vec3_sub(high, low);
    return fmax(size.x, fmax(size.y, size.z));
}

/* One cell for each hit, then those at one place joined; returns how many. */
static size_t cells_join(struct cell *cells, const struct bright_hit *hits,
                         size_t count, double side)
{
    size_t joined = 0;
    for (size_t i = 0; i < count; i++) {
        vec3 at = vec3_scale(hits[i].place, 1 / side);
        cells[i] = (struct cell){ { (int)floor(at.x), (int)floor(at.y),
                                    (int)floor(at.z) },
                                  1,
                                  hits[i].light };
    }
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
        last->count++;
        last->light += cells[i].light;
    }
    return joined;
}

/* The brightest cells, if they are brighter by far than others and send much of
 * all light along few of the ways: what is sent everywhere would have that much
 * more variance, and else is spread more evenly. */
static void bright_choose(struct bright *bright, struct cell *cells,
                          size_t joined, double side)
{
    double total = 0, chosen = 0, hits = 0, few = 0;
    for (size_t i = 0; i < joined; i++) {
        total += cells[i].light;
        hits += cells[i].count;
    }
    qsort(cells, joined, sizeof *cells, cell_brighter);
    for (size_t i = 0; i < joined && bright->count < BRIGHT_MOST; i++) {
        const struct cell *cell = &cells[i];
        double light = cell->light / cell->count;
        if (light <= bright_times * total / hits)
            continue;
        chosen += cell->light;
        few += cell->count;
        bright->at[bright->count].light = light;
        bright->at[bright->count++].centre = vec3_scale(
            vec3_make(cell->at[0] + 0.5, cell->at[1] + 0.5, cell->at[2] + 0.5),
            side);
    }
    double part = chosen / total;
    if (!(part * part >= bright_gain * few / hits))
        bright->count = 0;
}

struct bright bright_of(const struct bright_hit *hits, size_t count)
{
    struct bright bright = { .count = 0 };
    double size = count > 0 ? hits_size(hits, count) : 0;
    if (!(size > 0))
        return bright;
    double side = exp2(floor(log2(size / bright_cells)));
    struct cell *cells = memory_new(count * sizeof *cells);
    size_t joined = cells_join(cells, hits, count, side);
    bright.radius = side * bright_ball;
    bright_choose(&bright, cells, joined, side);
    memory_free(cells);
    return bright;
}

void aim_take(struct aim *aim, const struct bright *bright, vec3 place)
{
    double sum = 0;
    aim->count = bright->count;
    for (int i = 0; i < aim->count; i++) {
        vec3 offset = vec3_sub(bright->at[i].centre, place);
        double distance = vec3_length(offset), sine = bright->radius / distance;
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

vec3 aim_way(const struct aim *aim, const double u[2])
{
    double share, sum = aim->sums[aim->count - 1];
    size_t i = draw_share(aim->sums, (size_t)aim->count, u[0], &share);
    double before = i > 0 ? aim->sums[i - 1] / sum : 0;
    double within[2] = { fmin(fmax((u[0] - before) / share, 0), 1), u[1] };
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
