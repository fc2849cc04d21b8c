/* Bright places: see bright.h. */
#include "lightmesh/bright.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/side.h"
#include "base/warp.h"
#include "lightmesh/tuning.h"

/* Those that bring most first; the order of cells decides where they are alike.
 */
static int cell_brighter(const void *a, const void *b)
{
    const struct hit_cell *x = a, *y = b;
    return hit_cell_order(x->light, y->light, x, y);
}

double bright_beyond(double light, double least)
{
    return fmin(fmax(light / least - 1, 0) / bright_fade, 1);
}

/* The cells that bring most, if they are brighter by far than others. All that
 * are so beyond doubt are alike: what few hits say of how bright each is would
 * change from picture to picture of an animation, and rays with it. Nothing is
 * left out but what hardly matters, since whether it is aimed at does. */
static void bright_choose(struct bright *bright, struct hit_cell *cells,
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
        const struct hit_cell *cell = &cells[i];
        double worth = bright_beyond(cell->light / cell->count,
                                     bright_times * total / hits) *
                       bright_beyond(cell->light, rest);
        if (worth > 0)
            bright->at[bright->count++] =
                (struct bright_disc){ hit_cell_centre(cell, side),
                                      side_normal(cell->facing), worth };
    }
}

struct bright bright_of(const struct bright_hit *hits, size_t count)
{
    struct bright bright = { .count = 0 };
    struct hit_room room = hit_room_of(hits, count);
    double side = hit_room_cell(&room);
    if (!(side > 0))
        return bright;
    struct hit_cell *cells = memory_new(count * sizeof *cells);
    size_t joined = hit_cells_join(cells, hits, count, &room, side);
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
