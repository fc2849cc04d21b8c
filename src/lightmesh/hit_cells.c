/* Hits by cells: see hit_cells.h. */
#include "lightmesh/hit_cells.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/random.h"
#include "base/side.h"
#include "lightmesh/tuning.h"

static const double cell_last = 1e9;

/* Where the light of a hit comes from. */
struct source {
    vec3 place;
    int side;
};

static int cell_place_order(const void *a, const void *b)
{
    const struct hit_cell *x = a, *y = b;
    for (int axis = 0; axis < 3; axis++)
        if (x->at[axis] != y->at[axis])
            return x->at[axis] < y->at[axis] ? -1 : 1;
    if (x->facing != y->facing)
        return x->facing < y->facing ? -1 : 1;
    if (x->along < y->along || x->along > y->along)
        return x->along < y->along ? -1 : 1;
    return (x->light > y->light) - (x->light < y->light);
}

int hit_cell_order(double x, double y, const struct hit_cell *a,
                   const struct hit_cell *b)
{
    return x < y || x > y ? (x < y) - (x > y) : cell_place_order(a, b);
}

vec3 bright_hit_place(const struct bright_hit *hit)
{
    return vec3_along(hit->origin, hit->direction, hit->distance);
}

/* Where the walls are that face a side: all but the tenth of them that is
 * farthest out, which may be of other things beyond a window. Those of any side
 * where none do. `room` has room for all. */
static double room_end(const struct bright_hit *hits, size_t count, int side,
                       double *room)
{
    size_t n = 0, facing = 0;
    for (size_t i = 0; i < count; i++)
        facing +=
            hits[i].distance < HUGE_VAL && side_of(hits[i].normal) == side;
    for (size_t i = 0; i < count; i++)
        if (hits[i].distance < HUGE_VAL &&
            (facing == 0 || side_of(hits[i].normal) == side))
            room[n++] = vec3_component(bright_hit_place(&hits[i]), side / 2);
    qsort(room, n, sizeof *room, order_double);
    return n == 0 ? 0 : side % 2 ? room[n - 1 - n / 10] : room[n / 10];
}

struct hit_room hit_room_of(const struct bright_hit *hits, size_t count)
{
    struct hit_room box;
    double *room = memory_new((count + 1) * sizeof *room);
    for (int axis = 0; axis < 3; axis++) {
        double a = room_end(hits, count, 2 * axis, room);
        double b = room_end(hits, count, 2 * axis + 1, room);
        box.low[axis] = fmin(a, b);
        box.high[axis] = fmax(a, b);
    }
    memory_free(room);
    return box;
}

double hit_room_size(const struct hit_room *room)
{
    double size = 0;
    for (int axis = 0; axis < 3; axis++)
        size = fmax(size, room->high[axis] - room->low[axis]);
    return size;
}

double hit_room_cell(const struct hit_room *room)
{
    double size = hit_room_size(room);
    return size > 0 && isfinite(size) ? exp2(floor(log2(size / bright_cells)))
                                      : 0;
}

/* What is met in the chamber, or where the ray leaves it. */
static struct source hit_source(const struct bright_hit *hit,
                                const struct hit_room *room)
{
    struct source source = { hit->origin, 0 };
    double leaves = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++) {
        double from = vec3_component(hit->origin, axis);
        double way = vec3_component(hit->direction, axis);
        double t =
            ((way > 0 ? room->high[axis] : room->low[axis]) - from) / way;
        if (fabs(way) > 0 && t >= 0 && t < leaves) {
            leaves = t;
            source.side = 2 * axis + (way > 0);
        }
    }
    /* Walls are where it leaves as well. */
    if (hit->distance <= leaves + bright_wall * hit_room_size(room)) {
        leaves = hit->distance;
        source.side = side_of(hit->normal);
    }
    if (leaves < HUGE_VAL)
        source.place = vec3_along(hit->origin, hit->direction, leaves);
    return source;
}

static struct source hit_surface(const struct bright_hit *hit)
{
    return (struct source){ bright_hit_place(hit), side_of(hit->normal) };
}

/* A cell's number along an axis; beyond the last all are one. */
static double cell_number(double x, double side)
{
    return floor(fmin(fmax(x / side, -cell_last), cell_last));
}

/* The cell of a place that faces a side, whole numbers: that before it, since
 * walls are likely to be where cells end. */
static vec3 cell_at(vec3 place, int facing, double side)
{
    vec3 before = vec3_along(place, side_normal(facing), side / 4);
    return vec3_make(cell_number(before.x, side), cell_number(before.y, side),
                     cell_number(before.z, side));
}

/* One cell for each hit, then those at one place are joined. */
size_t hit_cells_join(struct hit_cell *cells, const struct bright_hit *hits,
                      size_t count, const struct hit_room *room, double side)
{
    size_t joined = 0;
    for (size_t i = 0; i < count; i++) {
        struct source source =
            room ? hit_source(&hits[i], room) : hit_surface(&hits[i]);
        vec3 at = cell_at(source.place, source.side, side);
        double along = vec3_component(source.place, source.side / 2);
        cells[i] = (struct hit_cell){ .at = { (int)at.x, (int)at.y, (int)at.z },
                                      .facing = source.side,
                                      .count = 1,
                                      .along = along,
                                      .light = hits[i].light,
                                      .lamps = hits[i].lamps };
    }
    qsort(cells, count, sizeof *cells, cell_place_order);
    for (size_t i = 0; i < count; i++) {
        struct hit_cell *last = &cells[joined - (joined > 0)];
        bool same = joined > 0 && last->at[0] == cells[i].at[0] &&
                    last->at[1] == cells[i].at[1] &&
                    last->at[2] == cells[i].at[2] &&
                    last->facing == cells[i].facing;
        if (!same) {
            cells[joined++] = cells[i];
            continue;
        }
        last->count++;
        last->along += cells[i].along;
        last->light += cells[i].light;
        last->lamps += cells[i].lamps;
    }
    return joined;
}

vec3 hit_cell_centre(const struct hit_cell *cell, double side)
{
    double at[3];
    for (int axis = 0; axis < 3; axis++)
        at[axis] = axis == cell->facing / 2 ? cell->along / cell->count
                                            : (cell->at[axis] + 0.5) * side;
    return vec3_make(at[0], at[1], at[2]);
}

vec3 cell_middle(vec3 place, int facing, double side)
{
    vec3 at = cell_at(place, facing, side);
    vec3 middle = vec3_scale(vec3_add(at, vec3_make(0.5, 0.5, 0.5)), side);
    return vec3_along(middle, side_normal(facing), -side / 4);
}

uint64_t cell_key(vec3 place, int facing, double side)
{
    vec3 at = cell_at(place, facing, side);
    uint64_t key = (uint64_t)facing;
    for (int axis = 0; axis < 3; axis++)
        key = random_key(key, (uint64_t)(int64_t)vec3_component(at, axis));
    return key ? key : 1;
}
