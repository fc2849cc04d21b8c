/* The points of an area light's grid at surfaces side by side: see
 * lamplights_area.h. */
#include "lighting/lamplights_area.h"

#include <string.h>

#include "shade/area.h"

/* Some of the grid's points as each lane sees them. */
struct area_lanes {
    const struct lamp *lamp;
    unsigned lanes;
    bool one; /* a grid that turns to nobody and is the same for all */
    struct area_grid grid[RAY_LANES];
    struct area_points points[RAY_LANES];
    LANE_LINES double share[3][RAY_LANES];
};

/* One point of the grid from all lanes. */
struct area_looks {
    LANE_LINES double location[3][RAY_LANES], direction[3][RAY_LANES];
    double distance[RAY_LANES], attenuation[RAY_LANES];
};

static void area_lanes_start(struct area_lanes *area,
                             const struct lamplights *lights,
                             const struct lamp *lamp, unsigned lanes,
                             const rgb *shares)
{
    const struct light *light = lamp->light;
    double points = (double)light->size1 * light->size2;
    area->lamp = lamp;
    area->lanes = lanes;
    area->one = !light->orient && !light->jitter;
    memset(area->share, 0, sizeof area->share);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        rgb share = rgb_scale(shares[i], 1.0 / points);
        area->grid[i] = area_grid_new(lamp, lane_get(lights->facets->point, i),
                                      lights->lamps->seed);
        lane_put(area->share, i, vec3_of(share));
    }
}

/* So many from the first on, line by line. */
static void area_lanes_find(struct area_lanes *area, int64_t first, int count)
{
    unsigned lanes = area->one ? area->lanes & -area->lanes : area->lanes;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        struct area_points *points = &area->points[i];
        points->count = count;
        for (int k = 0; k < count; k++) {
            points->at[0][k] = (double)((first + k) / area->grid[i].size2);
            points->at[1][k] = (double)((first + k) % area->grid[i].size2);
        }
        area_grid_points(&area->grid[i], points);
    }
}

/* lamp_look of lamps that shine evenly. */
CLONES static void looks_find(const double (*restrict points)[RAY_LANES],
                              struct area_looks *restrict looks)
{
    for (unsigned i = 0; i < RAY_LANES; i++) {
        vec3 offset =
            vec3_sub(lane_get(points, i),
                     lane_get((const double(*)[RAY_LANES])looks->location, i));
        double distance = vec3_length(offset);
        lane_put(looks->direction, i, vec3_scale(offset, -1 / distance));
        looks->distance[i] = distance;
        looks->attenuation[i] = 1;
    }
}

CLONES static void colours_of(rgb light, const struct area_lanes *restrict area,
                              const struct area_looks *restrict looks,
                              double (*restrict colours)[RAY_LANES])
{
    for (int i = 0; i < RAY_LANES; i++) {
        rgb whole = rgb_scale(light, looks->attenuation[i]);
        colours[0][i] = whole.r * area->share[0][i];
        colours[1][i] = whole.g * area->share[1][i];
        colours[2][i] = whole.b * area->share[2][i];
    }
}

/* Those of the lanes that point k of those found lights. */
static unsigned area_lanes_look(const struct area_lanes *area,
                                const struct facets *facets, unsigned k,
                                struct area_looks *looks)
{
    const double(*points)[RAY_LANES] =
        (const double(*)[RAY_LANES])facets->point;
    unsigned lit = area->lanes, first = (unsigned)__builtin_ctz(lit);
    for (unsigned i = 0; i < RAY_LANES; i++) {
        unsigned from = area->one || !(lit >> i & 1) ? first : i;
        lane_put(
            looks->location, i,
            lane_get((const double(*)[RAY_LANES])area->points[from].location,
                     k));
    }
    looks_find(points, looks);
    for (unsigned each = lit; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        struct lamp_view view;
        if (area->lamp->even && looks->distance[i] > 0)
            continue;
        if (!lamp_look(area->lamp,
                       lane_get((const double(*)[RAY_LANES])looks->location, i),
                       lane_get(points, i), &view))
            lit &= ~(1u << i);
        lane_put(looks->direction, i, view.direction);
        looks->attenuation[i] = view.attenuation;
    }
    return lit;
}

void lamplights_add_area(struct lamplights *lights, const struct lamp *lamp,
                         unsigned lanes, const rgb *shares)
{
    struct area_lanes area;
    struct area_looks looks;
    struct facets_lit lit = { .highlights = !lamp->light->shadowless };
    int64_t left = (int64_t)lamp->light->size1 * lamp->light->size2, first = 0;
    lit.direction = (const double(*)[RAY_LANES])looks.direction;
    area_lanes_start(&area, lights, lamp, lanes, shares);
    for (; lanes && left > 0 && !worker_stopped(lights->worker);
         left -= RAY_LANES, first += RAY_LANES) {
        int count = left < RAY_LANES ? (int)left : RAY_LANES;
        area_lanes_find(&area, first, count);
        for (int k = 0; k < count; k++) {
            unsigned seen =
                area_lanes_look(&area, lights->facets, (unsigned)k, &looks);
            colours_of(lamp->light->colour, &area, &looks, lit.colour);
            facets_add(lights->facets, &lit, seen);
        }
    }
}
