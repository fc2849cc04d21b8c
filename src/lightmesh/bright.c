/* Bright places: see bright.h. */
#include "lightmesh/bright.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/random.h"
#include "base/side.h"
#include "base/warp.h"
#include "lightmesh/tuning.h"

static const double cell_last = 1e9;

/* Hits in one cell that face one way. */
struct cell {
    int at[3], side;
    int count;
    double along; /* the axis; their sum, as of the light */
    double light;
};

/* Where the light of a hit comes from. */
struct source {
    vec3 place;
    int side;
};

struct box {
    double low[3], high[3];
};

static int cell_order(const void *a, const void *b)
{
    const struct cell *x = a, *y = b;
    for (int axis = 0; axis < 3; axis++)
        if (x->at[axis] != y->at[axis])
            return x->at[axis] < y->at[axis] ? -1 : 1;
    if (x->side != y->side)
        return x->side < y->side ? -1 : 1;
    if (x->along < y->along || x->along > y->along)
        return x->along < y->along ? -1 : 1;
    return (x->light > y->light) - (x->light < y->light);
}

/* Those that bring most first; the order of cells decides where they are alike.
 */
static int cell_brighter(const void *a, const void *b)
{
    const struct cell *x = a, *y = b;
    return x->light < y->light || x->light > y->light
               ? (x->light < y->light) - (x->light > y->light)
               : cell_order(a, b);
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

/* The chamber that most hits are in. */
static struct box room_of(const struct bright_hit *hits, size_t count)
{
    struct box box;
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

static double box_size(const struct box *box)
{
    double size = 0;
    for (int axis = 0; axis < 3; axis++)
        size = fmax(size, box->high[axis] - box->low[axis]);
    return size;
}

/* What is met in the chamber, or where the ray leaves it. */
static struct source hit_source(const struct bright_hit *hit,
                                const struct box *room)
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
    if (hit->distance <= leaves + bright_wall * box_size(room)) {
        leaves = hit->distance;
        source.side = side_of(hit->normal);
    }
    if (leaves < HUGE_VAL)
        source.place = vec3_along(hit->origin, hit->direction, leaves);
    return source;
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

/* One cell for each hit, then those at one place joined; returns how many. */
static size_t cells_join(struct cell *cells, const struct bright_hit *hits,
                         size_t count, const struct box *room, double side)
{
    size_t joined = 0;
    for (size_t i = 0; i < count; i++) {
        struct source source = hit_source(&hits[i], room);
        vec3 at = cell_at(source.place, source.side, side);
        cells[i] = (struct cell){ { (int)at.x, (int)at.y, (int)at.z },
                                  source.side,
                                  1,
                                  vec3_component(source.place, source.side / 2),
                                  hits[i].light };
    }
    qsort(cells, count, sizeof *cells, cell_order);
    for (size_t i = 0; i < count; i++) {
        struct cell *last = &cells[joined - (joined > 0)];
        bool same = joined > 0 && last->at[0] == cells[i].at[0] &&
                    last->at[1] == cells[i].at[1] &&
                    last->at[2] == cells[i].at[2] &&
                    last->side == cells[i].side;
        if (!same) {
            cells[joined++] = cells[i];
            continue;
        }
        last->count++;
        last->along += cells[i].along;
        last->light += cells[i].light;
    }
    return joined;
}

/* In the plane of what is in the cell. */
static vec3 cell_centre(const struct cell *cell, double side)
{
    double at[3];
    for (int axis = 0; axis < 3; axis++)
        at[axis] = axis == cell->side / 2 ? cell->along / cell->count
                                          : (cell->at[axis] + 0.5) * side;
    return vec3_make(at[0], at[1], at[2]);
}

/* By how much light is more than the least that counts, 0 to 1. */
static double bright_beyond(double light, double least)
{
    return fmin(fmax(light / least - 1, 0) / bright_fade, 1);
}

/* The cells that bring most, if they are brighter by far than others. All that
 * are so beyond doubt are alike: what few hits say of how bright each is would
 * change from picture to picture of an animation, and rays with it. Nothing is
 * left out but what hardly matters, since whether it is aimed at does. */
static void bright_choose(struct bright *bright, struct cell *cells,
                          size_t joined, double side)
{
    double total = 0, hits = 0;
    for (size_t i = 0; i < joined; i++) {
        total += cells[i].light;
        hits += cells[i].count;
    }
    qsort(cells, joined, sizeof *cells, cell_brighter);
    double rest = joined > BRIGHT_MOST ? cells[BRIGHT_MOST].light : 0;
    rest = fmax(rest, bright_least * total);
    for (size_t i = 0; i < joined && bright->count < BRIGHT_MOST; i++) {
        const struct cell *cell = &cells[i];
        double worth = bright_beyond(cell->light / cell->count,
                                     bright_times * total / hits) *
                       bright_beyond(cell->light, rest);
        if (worth > 0)
            bright->at[bright->count++] =
                (struct bright_disc){ cell_centre(cell, side),
                                      side_normal(cell->side), worth };
    }
}

struct bright bright_of(const struct bright_hit *hits, size_t count)
{
    struct bright bright = { .count = 0 };
    struct box room = room_of(hits, count);
    double size = box_size(&room);
    if (!(size > 0) || !isfinite(size))
        return bright;
    double side = exp2(floor(log2(size / bright_cells)));
    struct cell *cells = memory_new(count * sizeof *cells);
    size_t joined = cells_join(cells, hits, count, &room, side);
    bright.radius = side * bright_round;
    bright_choose(&bright, cells, joined, side);
    memory_free(cells);
    return bright;
}

/* The solid angle of a disc, about, from before it. */
static double disc_angle(const struct aim *aim, const struct aim_disc *disc)
{
    double square = vec3_dot(disc->offset, disc->offset);
    double facing = -vec3_dot(disc->offset, disc->normal);
    double area = aim->radius * aim->radius;
    if (!(facing > 0))
        return 0;
    return WARP_PI * area * facing / ((square + area) * sqrt(square));
}

double bright_side(const struct bright *bright)
{
    return bright->radius / bright_round;
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

static void aim_lane(struct aim *aim, int i)
{
    const struct aim_disc *disc = &aim->disc[i];
    struct aim_lanes *lanes = &aim->lanes;
    double height = -vec3_dot(disc->offset, disc->normal);
    double square = aim->radius * aim->radius;
    for (int axis = 0; axis < 3; axis++) {
        lanes->offset[axis][i] = vec3_component(disc->offset, axis);
        lanes->against[axis][i] = -vec3_component(disc->normal, axis);
    }
    lanes->height[i] = height;
    lanes->beside[i] = vec3_dot(disc->offset, disc->offset) - square;
    lanes->rays[i] = disc->rays * height * height / (WARP_PI * square);
}

void aim_take(struct aim *aim, const struct bright *bright, vec3 place,
              uint32_t rays)
{
    double share[BRIGHT_MOST], sum = 0;
    int count = 0;
    double side = bright_side(bright);
    aim->radius = bright->radius;
    aim->rays = 0;
    for (int i = 0; i < bright->count; i++) {
        struct aim_disc *disc = &aim->disc[i];
        disc->offset = vec3_sub(bright->at[i].centre, place);
        disc->normal = bright->at[i].normal;
        disc->key = cell_key(bright->at[i].centre, side_of(disc->normal), side);
        sum += share[i] = bright->at[i].worth * disc_angle(aim, disc);
    }
    for (int i = 0; i < bright->count; i++) {
        double wanted = sum > 0 ? rays * share[i] / sum : 0;
        if (!(wanted > 0))
            continue;
        aim->disc[count] = aim->disc[i];
        aim->disc[count].rays = fmin(wanted, AIM_RAYS_MOST);
        aim->rays += aim->disc[count].rays;
        aim_lane(aim, count++);
    }
    aim->count = count;
}

vec3 aim_way(const struct aim *aim, const struct aim_disc *disc,
             const double u[2])
{
    vec3 a, b;
    double x, y;
    warp_frame(disc->normal, &a, &b);
    warp_disc(u, &x, &y);
    vec3 to = vec3_along(vec3_along(disc->offset, a, aim->radius * x), b,
                         aim->radius * y);
    return vec3_normalise(to);
}

/* Of each disc. A way meets its plane at height / facing; all is multiplied by
 * facing squared, so that nothing is divided where nothing is met. */
CLONES static void lanes_density(const struct aim_lanes *lanes, int count,
                                 const double way[3],
                                 double density[BRIGHT_MOST])
{
    const double x = way[0], y = way[1], z = way[2];
    for (int i = 0; i < count; i++) {
        double facing = x * lanes->against[0][i] + y * lanes->against[1][i] +
                        z * lanes->against[2][i];
        double along = x * lanes->offset[0][i] + y * lanes->offset[1][i] +
                       z * lanes->offset[2][i];
        double height = lanes->height[i];
        double outside = height * (height - 2 * along * facing) +
                         lanes->beside[i] * facing * facing;
        double each = lanes->rays[i] / (facing * facing * facing);
        density[i] = ((facing > 0) & (outside <= 0)) ? each : 0;
    }
}

double aim_density(const struct aim *aim, vec3 way)
{
    const double direction[3] = { way.x, way.y, way.z };
    double each[BRIGHT_MOST], density = 0;
    if (aim->count == 0)
        return 0;
    lanes_density(&aim->lanes, aim->count, direction, each);
    for (int i = 0; i < aim->count; i++)
        density += each[i];
    return density;
}
