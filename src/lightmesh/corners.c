/* Corners around a place: see corners.h. */
#include "lightmesh/corners.h"

#include <string.h>

#include "lightmesh/tuning.h"

static void corners_hold(struct corners *corners,
                         const struct corners_asker *ask)
{
    memcpy(corners->weight, corners->grid, sizeof corners->weight);
    corners->hold = corner_cell_holds(ask->store, ask->worker, corners->cell,
                                      ask->receiver, corners->weight);
}

/* The cell that was last asked on that level, if the place is in it and it is
 * flat: most pixels are in that of the one before. */
static bool corners_again(struct corners *corners,
                          const struct corners_asker *ask, int level,
                          int coarser)
{
    struct corner_cell *cell =
        corner_store_last(ask->store, ask->worker, level);
    if (!cell || cell->flat <= 0 || cell->coarser != coarser ||
        !vec3_same(cell->name.side, receiver_seen(ask->receiver)) ||
        !surface_grid_within(ask->store->grid, &cell->name,
                             ask->receiver->point, corners->grid))
        return false;
    corners->cell = cell;
    corners_hold(corners, ask);
    return corners->hold != CELL_BENT;
}

/* The cell around the place. */
static void corners_cell(struct corners *corners,
                         const struct corners_asker *ask, int level,
                         int coarser)
{
    struct grid_cell name;
    corners->cell = NULL;
    corners->hold = CELL_BENT;
    if (!surface_grid_cell(ask->store->grid, ask->receiver, level, &name,
                           corners->grid))
        return;
    corners->cell = corner_store_cell(ask->store, ask->worker, &name, coarser,
                                      &corners->own);
    if (!receiver_is_bumpy(ask->receiver))
        corners_hold(corners, ask);
}

void corners_begin(struct corners *corners, const struct corners_asker *ask,
                   int level)
{
    const int coarser = point_mesh_worth(ask->receiver->weight);
    if (receiver_is_bumpy(ask->receiver) ||
        !corners_again(corners, ask, level, coarser))
        corners_cell(corners, ask, level, coarser);
    if (corners->hold >= CELL_HOLDS)
        corner_cell_ask(ask->store, ask->worker, corners->cell, ask->receiver);
}

void corners_find(struct corners *corners, const struct corners_asker *ask,
                  bool all)
{
    corners->count = 0;
    corners->sum = 0;
    corners->missing = !corners->cell;
    if (corners->missing)
        return;
    for (int i = 0; i < GRID_CORNERS && !(all && corners->missing); i++) {
        if (corners->grid[i] < indirect_pixels_least)
            continue;
        const struct corner *corner = corner_store_corner(
            ask->store, ask->worker, corners->cell, i, ask->receiver);
        if (!corner_serves(corner, ask->receiver)) {
            corners->missing = true;
            continue;
        }
        corners->sum += corners->grid[i];
        corners->at[corners->count].number = i;
        corners->at[corners->count].weight = corners->grid[i];
        corners->at[corners->count++].corner = corner;
    }
}

void corners_ask(struct corners *corners, const struct corners_asker *ask)
{
    for (int i = 0; i < corners->count; i++)
        corners->at[i].light =
            corner_store_light(ask->store, ask->worker, corners->cell,
                               corners->at[i].number, ask->receiver);
}

double corners_differ(const struct corners *corners,
                      const struct corners_asker *ask)
{
    const struct indirect_share *shares[GRID_CORNERS];
    if (corners->count == GRID_CORNERS && corners->hold != CELL_CLIPPED) {
        corner_cell_ask(ask->store, ask->worker, corners->cell, ask->receiver);
        return corners->cell->differ;
    }
    for (int i = 0; i < corners->count; i++)
        shares[i] = &corners->at[i].light->share;
    return corners->count == 0 ? 0 : shares_differ(shares, corners->count);
}

void corners_look(struct corners *corners, const struct corners_asker *ask)
{
    int count = corners->count;
    bool alike = corners_differ(corners, ask) <= indirect_pixels_even;
    if (corners->missing
            ? alike && count > 2
            : alike || corner_cell_clear(ask->store, ask->worker, corners->cell,
                                         ask->receiver))
        return;
    corners->count = 0;
    corners->sum = 0;
    for (int i = 0; i < count; i++) {
        if (!corner_sees(corners->at[i].corner, ask->store->mesh, ask->worker,
                         ask->receiver))
            continue;
        corners->sum += corners->at[i].weight;
        corners->at[corners->count++] = corners->at[i];
    }
}

/* Irradiance is interpolated as it is, between corners whose normals follow
 * the surface. */
static struct indirect_share corners_smooth(const struct corners *corners)
{
    struct indirect_share share = { rgb_grey(0), 0 };
    for (int i = 0; i < corners->count; i++) {
        const struct indirect_share *known = &corners->at[i].light->share;
        double weight = corners->at[i].weight / corners->sum;
        share.light = rgb_add_scaled(share.light, known->light, weight);
        share.open += weight * known->open;
    }
    return share;
}

static struct indirect_share corners_bumpy(const struct corners *corners,
                                           const struct receiver *receiver)
{
    struct indirect_light light = indirect_light_none;
    for (int i = 0; i < corners->count; i++)
        indirect_light_mix(&light, &corners->at[i].light->light,
                           (float)(corners->at[i].weight / corners->sum));
    return indirect_light_bumped(&light, receiver->side, receiver->smooth,
                                 receiver->normal);
}

struct indirect_share corners_light(const struct corners *corners,
                                    const struct corners_asker *ask)
{
    return receiver_is_bumpy(ask->receiver)
               ? corners_bumpy(corners, ask->receiver)
               : corners_smooth(corners);
}

struct indirect_share corners_flat_share(const struct corners *corners)
{
    const struct corner_cell *cell = corners->cell;
    struct indirect_share share = { rgb_grey(0), 0 };
    for (int i = 0; i < GRID_CORNERS; i++) {
        double weight = corners->weight[i];
        share.light = rgb_add_scaled(share.light, cell->share[i].light, weight);
        share.open += weight * cell->share[i].open;
    }
    return share;
}
