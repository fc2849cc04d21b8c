/* Indirect light between corners of surfaces: see indirect_pixels.h. */
#include "lightmesh/indirect_pixels.h"

#include <string.h>

#include "base/memory.h"
#include "lightmesh/corner_cell.h"
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

/* Who asks. */
struct asking {
    const struct indirect_pixels *pixels;
    struct worker *worker;
    const struct receiver *receiver;
    int level;    /* of corners, */
    double blend; /* and how much of those twice as far apart is blended in */
};

/* The corners around a place that serve it, with their weights. */
struct corners {
    struct grid_cell name;
    double weight[GRID_CORNERS];   /* of those of a cell that holds */
    struct corner_cell *cell, own; /* own: where the worker keeps none; NULL:
                                    * there is none */
    enum corner_hold hold;
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

/* Bumps take what comes from their own sides. */
static bool receiver_is_bumpy(const struct receiver *receiver)
{
    return vec3_dot(receiver->normal, receiver->side) < indirect_pixels_flat;
}

/* Finds the cell around a place on a level. Most pixels are on one plane with
 * all corners of their cell, which then says at once by how much they differ.
 */
static void corners_begin(struct corners *corners, const struct asking *ask,
                          int level)
{
    const struct indirect_pixels *pixels = ask->pixels;
    struct grid_cell *name = &corners->name;
    corners->cell = NULL;
    corners->hold = CELL_BENT;
    if (!surface_grid_cell(&pixels->grid, ask->receiver, level, name))
        return;
    corners->cell = corner_store_cell(pixels->store, ask->worker, name,
                                      point_mesh_worth(ask->receiver->weight),
                                      &corners->own);
    if (receiver_is_bumpy(ask->receiver))
        return;
    memcpy(corners->weight, name->weight, sizeof corners->weight);
    corners->hold = corner_cell_holds(pixels->store, ask->worker, corners->cell,
                                      ask->receiver, corners->weight);
    if (corners->hold >= CELL_HOLDS)
        corner_cell_ask(pixels->store, ask->worker, corners->cell,
                        ask->receiver);
}

/* What they know isn't asked yet. Leaves off at the first that is on another
 * surface if only all of them are wanted. */
static void corners_find(struct corners *corners, const struct asking *ask,
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
            ask->pixels->store, ask->worker, corners->cell, i, ask->receiver);
        if (!corner_serves(corner, ask->receiver)) {
            corners->missing = true;
            continue;
        }
        corners->sum += name->weight[i];
        corners->at[corners->count].number = i;
        corners->at[corners->count].weight = name->weight[i];
        corners->at[corners->count++].corner = corner;
    }
}

static void corners_ask(struct corners *corners, const struct asking *ask)
{
    for (int i = 0; i < corners->count; i++)
        corners->at[i].light =
            corner_store_light(ask->pixels->store, ask->worker, corners->cell,
                               corners->at[i].number, ask->receiver);
}

/* By how much; cells remember it for all of theirs. */
static double corners_differ(const struct corners *corners,
                             const struct asking *ask)
{
    const struct indirect_share *shares[GRID_CORNERS];
    if (corners->count == GRID_CORNERS && corners->hold != CELL_CLIPPED) {
        corner_cell_ask(ask->pixels->store, ask->worker, corners->cell,
                        ask->receiver);
        return corners->cell->differ;
    }
    for (int i = 0; i < corners->count; i++)
        shares[i] = &corners->at[i].light->share;
    return corners->count == 0 ? 0 : shares_differ(shares, corners->count);
}

/* Leaves out what can't be seen from the place, where it matters: where corners
 * differ much something may stand between, or on one; where another surface is
 * near, a wall may stand between all corners and the place. */
static void corners_look(struct corners *corners, const struct asking *ask)
{
    int count = corners->count;
    bool alike = corners_differ(corners, ask) <= indirect_pixels_even;
    if (corners->missing
            ? alike && count > 2
            : alike || corner_cell_clear(ask->pixels->store, ask->worker,
                                         corners->cell, ask->receiver))
        return;
    corners->count = 0;
    corners->sum = 0;
    for (int i = 0; i < count; i++) {
        if (!corner_sees(corners->at[i].corner, ask->pixels->mesh, ask->worker,
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
    return indirect_light_bumped(&light, receiver->side, receiver->normal);
}

static struct indirect_share corners_light(const struct corners *corners,
                                           const struct asking *ask)
{
    return receiver_is_bumpy(ask->receiver)
               ? corners_bumpy(corners, ask->receiver)
               : corners_smooth(corners);
}

static struct indirect_share corners_flat_share(const struct corners *corners)
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

/* Where the grid's corners are on other surfaces: pixels of a block share, or
 * else rays of a pixel. */
static bool lone_light(const struct asking *ask, struct indirect_share *share)
{
    const struct indirect_pixels *pixels = ask->pixels;
    return pixel_blocks_light(pixels->blocks, ask->worker, ask->receiver,
                              share) ||
           lone_places_light(pixels->lone, ask->worker, ask->receiver, share);
}

static void share_blend(struct indirect_share *share,
                        const struct indirect_share *coarse, double blend)
{
    share->light = rgb_mix(share->light, coarse->light, blend);
    share->open += (coarse->open - share->open) * blend;
}

/* By corners of a level, and so much by those twice as far apart. */
static bool corners_blend(struct corners at[2], const struct asking *ask,
                          struct indirect_share *share)
{
    corners_look(&at[0], ask);
    if (at[0].sum < indirect_pixels_enough)
        return false;
    *share = corners_light(&at[0], ask);
    if (ask->blend <= 0 || at[1].missing)
        return true;
    corners_look(&at[1], ask);
    if (at[1].sum < indirect_pixels_enough)
        return true;
    struct indirect_share coarse = corners_light(&at[1], ask);
    share_blend(share, &coarse, ask->blend);
    return true;
}

/* How far corners twice as far apart are enough, which say about the same
 * there, and what they say. Those that hold aren't found by that. */
static double coarse_light(struct corners *corners, const struct asking *ask,
                           struct indirect_share *share)
{
    double enough;
    corners->missing = true;
    if (corners->hold == CELL_HOLDS) {
        enough = shares_evenness(corners->cell->differ);
        if (enough > 0)
            *share = corners_flat_share(corners);
        return enough;
    }
    if (corners->hold == CELL_BENT)
        corners_find(corners, ask, true);
    if (corners->missing)
        return 0;
    corners_ask(corners, ask);
    enough = shares_evenness(corners_differ(corners, ask));
    if (enough > 0)
        *share = corners_light(corners, ask);
    return enough;
}

/* On flat surfaces so much by those twice as far apart again, if they are
 * enough: where the level changes they are what is coarse. */
static void coarse_blend(const struct asking *ask, struct indirect_share *share)
{
    struct corners coarser;
    if (ask->blend <= 0)
        return;
    corners_begin(&coarser, ask, ask->level + 2);
    if (coarser.hold != CELL_HOLDS)
        return;
    const struct indirect_share more = corners_flat_share(&coarser);
    share_blend(share, &more,
                ask->blend * shares_evenness(coarser.cell->differ));
}

static bool cell_is_even(const struct corners *corners)
{
    return corners->hold == CELL_HOLDS &&
           corners->cell->differ <= indirect_pixels_even;
}

/* Between flat cells that are even, if both are that are wanted. */
static bool cells_light(const struct corners at[2], double blend,
                        struct indirect_share *share)
{
    bool mixed = blend > 0 && at[1].hold != CELL_FAR;
    if (!cell_is_even(&at[0]) || (mixed && !cell_is_even(&at[1])))
        return false;
    *share = corners_flat_share(&at[0]);
    if (mixed) {
        const struct indirect_share coarse = corners_flat_share(&at[1]);
        share_blend(share, &coarse, blend);
    }
    return true;
}

/* What stands for corners is asked in no other way. */
static bool clipped_light(const struct corners at[2], const struct asking *ask,
                          struct indirect_share *share)
{
    if (!corner_cell_whole(ask->pixels->store, ask->worker, at[0].cell,
                           ask->receiver))
        return false;
    *share = corners_flat_share(&at[0]);
    if (ask->blend > 0 && at[1].hold >= CELL_HOLDS &&
        corner_cell_whole(ask->pixels->store, ask->worker, at[1].cell,
                          ask->receiver)) {
        const struct indirect_share coarse = corners_flat_share(&at[1]);
        share_blend(share, &coarse, ask->blend);
    }
    return true;
}

/* By corners of the level, or blocks, or the receiver alone. */
static bool fine_light(struct corners at[2], const struct asking *ask,
                       struct indirect_share *share)
{
    corners_begin(&at[0], ask, ask->level);
    if (at[0].hold == CELL_CLIPPED ? clipped_light(at, ask, share)
                                   : cells_light(at, ask->blend, share))
        return true;
    corners_find(&at[0], ask, false);
    if (at[0].sum < indirect_pixels_enough)
        return lone_light(ask, share);
    if (at[1].hold == CELL_HOLDS) {
        corners_find(&at[1], ask, true);
        corners_ask(&at[1], ask);
    }
    corners_ask(&at[0], ask);
    return corners_blend(at, ask, share) || lone_light(ask, share);
}

static bool grid_light(const struct asking *ask, struct indirect_share *share)
{
    struct corners at[2];
    struct indirect_share coarse;
    corners_begin(&at[1], ask, ask->level + 1);
    double enough = coarse_light(&at[1], ask, &coarse);
    if (enough > 0 && at[1].hold == CELL_HOLDS)
        coarse_blend(ask, &coarse);
    if (enough >= 1)
        *share = coarse;
    else if (!fine_light(at, ask, share))
        return false;
    else if (enough > 0)
        share_blend(share, &coarse, enough);
    return true;
}

bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    struct asking ask = { .pixels = pixels,
                          .worker = worker,
                          .receiver = receiver };
    if (!receiver->pixel || indirect_mesh_leaves(pixels->mesh, receiver))
        return false;
    if (pixel_answers_find(pixels->answers, worker, receiver, share))
        return true;
    ask.level = surface_grid_level(&pixels->grid, receiver, &ask.blend);
    if (!grid_light(&ask, share))
        return false;
    pixel_answers_keep(pixels->answers, worker, receiver,
                       answer_reach * pixels->grid.step[ask.level], share);
    return true;
}
