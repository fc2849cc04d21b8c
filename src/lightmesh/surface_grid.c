/* Grids fixed to surfaces: see surface_grid.h. */
#include "lightmesh/surface_grid.h"

#include "base/smooth.h"
#include "lightmesh/tuning.h"
#include "scene/camera.h"

enum {
    GRID_TYPICAL = 12, /* the level whose step is what is typical */
    GRID_KINDS = 4,
    GRID_WAYS = 9,
    GRID_RIM = (1 << 16) - 4, /* names reach so far from the origin, steps */
};

/* Cells are moved by a fraction of their step, lest corners fall on the round
 * numbers that scenes are made of. */
static const double grid_shift[3] = { 0.3719, 0.4142, 0.2929 };

struct surface_grid surface_grid_new(const struct camera *camera,
                                     const int size[2], double apart,
                                     vec3 origin, double typical)
{
    struct ray a = camera_ray(camera, 0.5, 0.5),
               b = camera_ray(camera, 0.5 + 1.0 / size[0], 0.5);
    struct surface_grid grid = { .origin = origin,
                                 .central =
                                     camera->kind->lines == CAMERA_CENTRAL,
                                 .eye = camera->location };
    for (int level = 0; level < GRID_LEVELS; level++) {
        grid.step[level] = ldexp(typical, level - GRID_TYPICAL);
        grid.within[level] = 1 / grid.step[level];
    }
    apart *= grid.within[0];
    grid.wanted = apart * vec3_length(vec3_sub(a.origin, b.origin));
    grid.wanted_grows = apart * vec3_length(vec3_sub(a.direction, b.direction));
    return grid;
}

/* A surface seen from its edge has as many corners in the picture as one that
 * faces the camera. */
int surface_grid_level(const struct surface_grid *grid,
                       const struct receiver *receiver, double *blend)
{
    vec3 from = grid->central ? grid->eye : receiver->from;
    vec3 way = vec3_sub(from, receiver->point);
    double distance = vec3_length(way);
    double facing = fabs(vec3_dot(way, receiver->side)) / distance;
    double steps = grid->wanted + grid->wanted_grows * distance;
    int level;
    facing = facing > grid_facing_least ? facing : grid_facing_least;
    double part = frexp(grid_between * steps / sqrt(facing), &level);
    *blend = 0;
    if (!(level > 0))
        return 0;
    if (level >= GRID_LEVELS - 1)
        return GRID_LEVELS - 1;
    *blend = smooth_step((part - grid_blend) / (1 - grid_blend));
    return level;
}

static const int after[3] = { 1, 2, 0 }; /* each axis */

static int main_axis(const double side[3])
{
    int axis = fabs(side[1]) > fabs(side[0]);
    return fabs(side[2]) > fabs(side[axis]) ? 2 : axis;
}

/* Where it is on a level along an axis, in steps. */
static double grid_place(const struct surface_grid *grid, vec3 point, int level,
                         int axis)
{
    double from = vec3_component(grid->origin, axis);
    return (vec3_component(point, axis) - from) * grid->within[level] +
           grid_shift[axis];
}

/* Bilinear. */
static void cell_weights(double x, double y, double weight[GRID_CORNERS])
{
    weight[0] = (1 - x) * (1 - y);
    weight[1] = x * (1 - y);
    weight[2] = (1 - x) * y;
    weight[3] = x * y;
}

/* As floor, of what an int holds. */
static inline int floor_of(double x)
{
    int whole = (int)x;
    return whole - (whole > x);
}

bool surface_grid_cell(const struct surface_grid *grid,
                       const struct receiver *receiver, int level,
                       struct grid_cell *cell, double weight[GRID_CORNERS])
{
    double at[3];
    const vec3 seen = receiver_seen(receiver);
    const double side[3] = { seen.x, seen.y, seen.z };
    if (level >= GRID_LEVELS)
        return false;
    for (int i = 0; i < 3; i++)
        at[i] = grid_place(grid, receiver->point, level, i);
    if (!(fabs(at[0]) < GRID_RIM && fabs(at[1]) < GRID_RIM &&
          fabs(at[2]) < GRID_RIM))
        return false;
    int axis = main_axis(side), across = after[axis], down = after[across];
    int left = floor_of(at[across]), top = floor_of(at[down]);
    double x = at[across] - left, y = at[down] - top;
    double slope = -side[across] / side[axis], fall = -side[down] / side[axis];
    double rise = at[axis] - slope * x - fall * y;
    cell->level = level;
    cell->axis = axis;
    cell->down = side[axis] < 0;
    cell->at[0] = left;
    cell->at[1] = top;
    cell->slab[0] = floor_of(rise);
    cell->slab[1] = floor_of(rise + slope);
    cell->slab[2] = floor_of(rise + fall);
    cell->slab[3] = floor_of(rise + slope + fall);
    cell->side = seen;
    cell_weights(x, y, weight);
    return true;
}

bool surface_grid_within(const struct surface_grid *grid,
                         const struct grid_cell *cell, vec3 point,
                         double weight[GRID_CORNERS])
{
    int across = after[cell->axis], down = after[across];
    double x = grid_place(grid, point, cell->level, across) - cell->at[0];
    double y = grid_place(grid, point, cell->level, down) - cell->at[1];
    if (!(x >= 0 && x < 1 && y >= 0 && y < 1))
        return false;
    cell_weights(x, y, weight);
    return true;
}

bool grid_cells_same(const struct grid_cell *a, const struct grid_cell *b)
{
    int differ = (a->level ^ b->level) | (a->axis ^ b->axis) |
                 (a->down ^ b->down) | (a->at[0] ^ b->at[0]) |
                 (a->at[1] ^ b->at[1]);
    for (int i = 0; i < GRID_CORNERS; i++)
        differ |= a->slab[i] ^ b->slab[i];
    return differ == 0;
}

/* 8 bits of axis, side, kind and way, 5 of level, 3 times 17, biased. */
uint64_t grid_corner_key(const struct grid_cell *cell, int corner, int kind,
                         int way)
{
    int at[3] = { cell->at[0] + corner % 2, cell->at[1] + corner / 2,
                  cell->slab[corner] };
    int what = ((cell->axis * 2 + cell->down) * GRID_KINDS + kind) * GRID_WAYS;
    uint64_t key = 1 + (uint64_t)(what + way);
    key = key << 5 | (uint64_t)cell->level;
    for (int i = 0; i < 3; i++)
        key = key << 17 | (uint64_t)((at[i] + (1 << 16)) & ((1 << 17) - 1));
    return key;
}

vec3 grid_cell_along(const struct grid_cell *cell, vec3 side, int axis,
                     double step)
{
    const double normal[3] = { side.x, side.y, side.z };
    const int along = axis == 0 ? after[cell->axis] : after[after[cell->axis]];
    double way[3] = { 0, 0, 0 };
    way[along] = step;
    way[cell->axis] = -step * normal[along] / normal[cell->axis];
    return vec3_make(way[0], way[1], way[2]);
}

struct ray grid_corner_line(const struct surface_grid *grid,
                            const struct grid_cell *cell, int corner,
                            double *length)
{
    double step = grid->step[cell->level], at[3], way[3] = { 0, 0, 0 };
    int axis = cell->axis;
    at[after[axis]] = cell->at[0] + corner % 2;
    at[after[after[axis]]] = cell->at[1] + corner / 2;
    at[axis] = cell->down ? cell->slab[corner] - grid_margin
                          : cell->slab[corner] + 1 + grid_margin;
    way[axis] = cell->down ? 1 : -1;
    for (int i = 0; i < 3; i++)
        at[i] -= grid_shift[i];
    *length = (1 + 2 * grid_margin) * step;
    vec3 offset = vec3_make(at[0] * step, at[1] * step, at[2] * step);
    return (struct ray){ vec3_add(grid->origin, offset),
                         vec3_make(way[0], way[1], way[2]) };
}
