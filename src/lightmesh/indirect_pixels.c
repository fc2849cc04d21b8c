/* Indirect light between corners of surfaces: see indirect_pixels.h. */
#include "lightmesh/indirect_pixels.h"

#include "base/memory.h"
#include "lightmesh/corner_store.h"
#include "lightmesh/lone_places.h"
#include "lightmesh/pixel_answers.h"
#include "lightmesh/pixel_blocks.h"
#include "lightmesh/tuning.h"

struct indirect_pixels {
    const struct indirect_mesh *mesh;
    struct surface_grid grid;
    struct corner_store *store;
    struct pixel_blocks *blocks;
    struct pixel_answers *answers;
    struct lone_places *lone;
};

struct indirect_pixels *indirect_pixels_new(const struct indirect_mesh *mesh,
                                            const struct camera *camera,
                                            int width, int height,
                                            unsigned threads)
{
    struct indirect_pixels *pixels = memory_new(sizeof *pixels);
    const struct lattice *lattice = &mesh->points.lattice;
    const int size[2] = { width, height };
    double apart = sqrt((double)width * height / indirect_pixels_most);
    apart = fmin(fmax(apart, indirect_pixels_near), indirect_pixels_far);
    *pixels = (struct indirect_pixels){
        .mesh = mesh,
        .grid = surface_grid_new(camera, size, apart, mesh->gather.view.eye,
                                 lattice_spacing(lattice, lattice->usual)),
        .blocks = pixel_blocks_new(mesh, camera, size, apart, threads),
        .answers = pixel_answers_new(threads),
        .lone = lone_places_new(mesh, threads),
    };
    pixels->store = corner_store_new(mesh, camera, &pixels->grid, threads);
    return pixels;
}

void indirect_pixels_free(struct indirect_pixels *pixels)
{
    if (!pixels)
        return;
    corner_store_free(pixels->store);
    pixel_blocks_free(pixels->blocks);
    pixel_answers_free(pixels->answers);
    lone_places_free(pixels->lone);
    memory_free(pixels);
}

/* The corners around a place that serve it, with their weights. */
struct corners {
    struct grid_cell name;
    struct corner_cell *cell, own; /* own: where the worker keeps none; NULL:
                                    * there is none */
    int count;
    bool missing; /* another is on another surface */
    double sum;
    struct {
        int number; /* in the cell */
        double weight;
        const struct corner *corner;
        const struct corner_light *light;
    } at[GRID_CORNERS];
};

/* Names the cell around a place on a level. */
static void corners_begin(struct corners *corners,
                          const struct indirect_pixels *pixels,
                          const struct worker *worker,
                          const struct receiver *receiver, int level)
{
    struct grid_cell *name = &corners->name;
    corners->cell = NULL;
    if (surface_grid_cell(&pixels->grid, receiver, level, name))
        corners->cell = corner_store_cell(pixels->store, worker, name,
                                          point_mesh_worth(receiver->weight),
                                          &corners->own);
}

/* What they know isn't asked yet. Leaves off at the first that is on another
 * surface if only all of them are wanted. */
static void corners_find(struct corners *corners,
                         const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver,
                         bool all)
{
    const struct grid_cell *name = &corners->name;
    corners->count = 0;
    corners->sum = 0;
    corners->missing = !corners->cell;
    if (corners->missing)
        return;
    for (int i = 0; i < GRID_CORNERS && !(all && corners->missing); i++) {
        if (name->weight[i] < indirect_pixels_least)
            continue;
        const struct corner *corner = corner_store_corner(
            pixels->store, worker, corners->cell, i, receiver);
        if (!corner_serves(corner, receiver)) {
            corners->missing = true;
            continue;
        }
        corners->sum += name->weight[i];
        corners->at[corners->count].number = i;
        corners->at[corners->count].weight = name->weight[i];
        corners->at[corners->count++].corner = corner;
    }
}

static void corners_ask(struct corners *corners,
                        const struct indirect_pixels *pixels,
                        struct worker *worker, const struct receiver *receiver)
{
    for (int i = 0; i < corners->count; i++)
        corners->at[i].light =
            corner_store_light(pixels->store, worker, corners->cell,
                               corners->at[i].number, receiver);
}

/* Where they differ much something may stand between, or on a corner. Cells
 * remember by how much all of theirs do. */
static bool corners_alike(const struct corners *corners,
                          const struct indirect_pixels *pixels,
                          struct worker *worker,
                          const struct receiver *receiver, double even)
{
    const struct indirect_share *shares[GRID_CORNERS];
    if (corners->count == GRID_CORNERS) {
        corner_cell_ask(pixels->store, worker, corners->cell, receiver);
        return corners->cell->differ <= even;
    }
    for (int i = 0; i < corners->count; i++)
        shares[i] = &corners->at[i].light->share;
    return corners->count == 0 || shares_differ(shares, corners->count) <= even;
}

/* Leaves out what can't be seen from the place, where it matters: where another
 * surface is near, a wall may stand between all corners and the place. */
static void corners_look(struct corners *corners,
                         const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver)
{
    int count = corners->count;
    bool alike =
        corners_alike(corners, pixels, worker, receiver, indirect_pixels_even);
    if (corners->missing ? alike && count > 2
                         : alike || corner_store_clear(pixels->store, worker,
                                                       corners->cell, receiver))
        return;
    corners->count = 0;
    corners->sum = 0;
    for (int i = 0; i < count; i++) {
        if (!corner_sees(corners->at[i].corner, pixels->mesh, worker, receiver))
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
                                           vec3 normal)
{
    struct indirect_light light = indirect_light_none;
    for (int i = 0; i < corners->count; i++)
        indirect_light_mix(&light, &corners->at[i].light->light,
                           (float)(corners->at[i].weight / corners->sum));
    return indirect_light_share(&light, normal);
}

/* Bumps take what comes from their own sides. */
static bool receiver_is_bumpy(const struct receiver *receiver)
{
    return vec3_dot(receiver->normal, receiver->side) < indirect_pixels_flat;
}

/* Where the grid's corners are on other surfaces: pixels of a block share, or
 * else rays of a pixel. */
static bool lone_light(const struct indirect_pixels *pixels,
                       struct worker *worker, const struct receiver *receiver,
                       struct indirect_share *share)
{
    return pixel_blocks_light(pixels->blocks, worker, receiver, share) ||
           lone_places_light(pixels->lone, worker, receiver, share);
}

static struct indirect_share corners_light(const struct corners *corners,
                                           const struct receiver *receiver)
{
    return receiver_is_bumpy(receiver)
               ? corners_bumpy(corners, receiver->normal)
               : corners_smooth(corners);
}

static void share_blend(struct indirect_share *share,
                        const struct indirect_share *coarse, double blend)
{
    share->light = rgb_mix(share->light, coarse->light, blend);
    share->open += (coarse->open - share->open) * blend;
}

/* By corners of a level, and so much by those twice as far apart. */
static bool corners_blend(const struct indirect_pixels *pixels,
                          struct worker *worker,
                          const struct receiver *receiver, struct corners at[2],
                          double blend, struct indirect_share *share)
{
    corners_look(&at[0], pixels, worker, receiver);
    if (at[0].sum < indirect_pixels_enough)
        return false;
    *share = corners_light(&at[0], receiver);
    if (blend <= 0 || at[1].missing)
        return true;
    corners_look(&at[1], pixels, worker, receiver);
    if (at[1].sum < indirect_pixels_enough)
        return true;
    struct indirect_share coarse = corners_light(&at[1], receiver);
    share_blend(share, &coarse, blend);
    return true;
}

/* Most pixels are on one plane with all corners of their cell, which then says
 * at once by how much they differ. */
static enum corner_hold corners_flat(const struct corners *corners,
                                     const struct indirect_pixels *pixels,
                                     struct worker *worker,
                                     const struct receiver *receiver)
{
    if (!corners->cell || receiver_is_bumpy(receiver))
        return CELL_BENT;
    enum corner_hold hold =
        corner_cell_holds(pixels->store, worker, corners->cell, receiver);
    if (hold == CELL_HOLDS)
        corner_cell_ask(pixels->store, worker, corners->cell, receiver);
    return hold;
}

static struct indirect_share corners_flat_share(const struct corners *corners)
{
    const struct corner_cell *cell = corners->cell;
    struct indirect_share share = { rgb_grey(0), 0 };
    for (int i = 0; i < GRID_CORNERS; i++) {
        double weight = corners->name.weight[i];
        share.light = rgb_add_scaled(share.light, cell->share[i].light, weight);
        share.open += weight * cell->share[i].open;
    }
    return share;
}

/* By corners twice as far apart, which are enough where they say about the
 * same. */
static bool corners_coarse(struct corners *corners,
                           const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    corners_find(corners, pixels, worker, receiver, true);
    if (corners->missing)
        return false;
    corners_ask(corners, pixels, worker, receiver);
    if (!corners_alike(corners, pixels, worker, receiver, indirect_pixels_same))
        return false;
    *share = corners_light(corners, receiver);
    return true;
}

/* Flat cells that are as even as that. */
static bool cell_is_even(const struct corners *corners, enum corner_hold hold,
                         double even)
{
    return hold == CELL_HOLDS && corners->cell->differ <= even;
}

/* Between flat cells that are even, if both are that are wanted. */
static bool cells_light(const struct corners at[2],
                        const enum corner_hold hold[2], double blend,
                        struct indirect_share *share)
{
    bool mixed = blend > 0 && hold[1] != CELL_FAR;
    if (!cell_is_even(&at[0], hold[0], indirect_pixels_even) ||
        (mixed && !cell_is_even(&at[1], hold[1], indirect_pixels_even)))
        return false;
    *share = corners_flat_share(&at[0]);
    if (mixed) {
        const struct indirect_share coarse = corners_flat_share(&at[1]);
        share_blend(share, &coarse, blend);
    }
    return true;
}

/* By those twice as far apart, where they are enough. If not, they are there
 * for corners_blend, unless cells_light needs none. */
static bool coarse_light(struct corners *corners, enum corner_hold hold,
                         const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver,
                         struct indirect_share *share)
{
    corners->missing = true;
    if (cell_is_even(corners, hold, indirect_pixels_same)) {
        *share = corners_flat_share(corners);
        return true;
    }
    return hold == CELL_BENT &&
           corners_coarse(corners, pixels, worker, receiver, share);
}

/* On flat surfaces so much by those twice as far apart again, if they are
 * enough: where the level changes they are what is coarse. */
static void coarse_blend(const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver,
                         int level, double blend, struct indirect_share *share)
{
    struct corners coarser;
    if (blend <= 0)
        return;
    corners_begin(&coarser, pixels, worker, receiver, level + 2);
    enum corner_hold hold = corners_flat(&coarser, pixels, worker, receiver);
    if (!cell_is_even(&coarser, hold, indirect_pixels_same))
        return;
    const struct indirect_share more = corners_flat_share(&coarser);
    share_blend(share, &more, blend);
}

/* By corners that are about `level` apart, or blocks, or the receiver alone. */
static bool grid_light(const struct indirect_pixels *pixels,
                       struct worker *worker, const struct receiver *receiver,
                       int level, double blend, struct indirect_share *share)
{
    struct corners at[2];
    enum corner_hold hold[2];
    corners_begin(&at[1], pixels, worker, receiver, level + 1);
    hold[1] = corners_flat(&at[1], pixels, worker, receiver);
    if (coarse_light(&at[1], hold[1], pixels, worker, receiver, share)) {
        if (hold[1] == CELL_HOLDS)
            coarse_blend(pixels, worker, receiver, level, blend, share);
        return true;
    }
    corners_begin(&at[0], pixels, worker, receiver, level);
    hold[0] = corners_flat(&at[0], pixels, worker, receiver);
    if (cells_light(at, hold, blend, share))
        return true;
    corners_find(&at[0], pixels, worker, receiver, false);
    if (at[0].sum < indirect_pixels_enough)
        return lone_light(pixels, worker, receiver, share);
    if (hold[1] == CELL_HOLDS) {
        corners_find(&at[1], pixels, worker, receiver, true);
        corners_ask(&at[1], pixels, worker, receiver);
    }
    corners_ask(&at[0], pixels, worker, receiver);
    return corners_blend(pixels, worker, receiver, at, blend, share) ||
           lone_light(pixels, worker, receiver, share);
}

bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    double blend;
    if (!receiver->pixel || indirect_mesh_leaves(pixels->mesh, receiver))
        return false;
    if (pixel_answers_find(pixels->answers, worker, receiver, share))
        return true;
    int level = surface_grid_level(&pixels->grid, receiver, &blend);
    if (!grid_light(pixels, worker, receiver, level, blend, share))
        return false;
    pixel_answers_keep(pixels->answers, worker, receiver,
                       answer_reach * pixels->grid.step[level], share);
    return true;
}
