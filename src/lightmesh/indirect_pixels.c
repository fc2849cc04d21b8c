/* Indirect light between corners of surfaces: see indirect_pixels.h. */
#include "lightmesh/indirect_pixels.h"

#include "base/memory.h"
#include "lightmesh/corners.h"
#include "lightmesh/lone_places.h"
#include "lightmesh/pixel_answers.h"
#include "lightmesh/pixel_blocks.h"
#include "lightmesh/tuning.h"

struct indirect_pixels {
    const struct indirect_mesh *mesh;
    struct surface_grid grid;
    struct corner_store *store[2];  /* of sides that are seen, and far ones */
    struct pixel_blocks *blocks[2]; /* likewise */
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
        .answers = pixel_answers_new(threads),
        .lone = lone_places_new(mesh, threads),
    };
    for (int far = 0; far < 2; far++) {
        pixels->store[far] =
            corner_store_new(mesh, camera, &pixels->grid, threads);
        pixels->blocks[far] =
            pixel_blocks_new(mesh, camera, size, apart, threads);
    }
    return pixels;
}

void indirect_pixels_free(struct indirect_pixels *pixels)
{
    if (!pixels)
        return;
    for (int far = 0; far < 2; far++) {
        corner_store_free(pixels->store[far]);
        pixel_blocks_free(pixels->blocks[far]);
    }
    pixel_answers_free(pixels->answers);
    lone_places_free(pixels->lone);
    memory_free(pixels);
}

/* Who asks. */
struct asking {
    const struct indirect_pixels *pixels;
    struct corners_asker who;
    int level;    /* of corners, */
    double blend; /* and how much of those twice as far apart is blended in */
};

/* Where the grid's corners are on other surfaces: pixels of a block share, or
 * else rays of a pixel. */
static bool lone_light(const struct asking *ask, struct indirect_share *share)
{
    const struct indirect_pixels *pixels = ask->pixels;
    const struct receiver *receiver = ask->who.receiver;
    return receiver->pixel &&
           (pixel_blocks_light(pixels->blocks[receiver->far_side],
                               ask->who.worker, receiver, share) ||
            (!receiver->far_side &&
             lone_places_light(pixels->lone, ask->who.worker, receiver,
                               share)));
}

/* By corners of a level, and so much by those twice as far apart. */
static bool corners_blend(struct corners at[2], const struct asking *ask,
                          struct indirect_share *share)
{
    corners_look(&at[0], &ask->who);
    if (at[0].sum < indirect_pixels_enough)
        return false;
    *share = corners_light(&at[0], &ask->who);
    if (ask->blend <= 0 || at[1].missing)
        return true;
    corners_look(&at[1], &ask->who);
    if (at[1].sum < indirect_pixels_enough)
        return true;
    struct indirect_share coarse = corners_light(&at[1], &ask->who);
    indirect_share_mix(share, &coarse, ask->blend);
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
        corners_find(corners, &ask->who, true);
    if (corners->missing)
        return 0;
    corners_ask(corners, &ask->who);
    enough = shares_evenness(corners_differ(corners, &ask->who));
    if (enough > 0)
        *share = corners_light(corners, &ask->who);
    return enough;
}

/* On flat surfaces so much by those twice as far apart again, if they are
 * enough: where the level changes they are what is coarse. */
static void coarse_blend(const struct asking *ask, struct indirect_share *share)
{
    struct corners coarser;
    if (ask->blend <= 0)
        return;
    corners_begin(&coarser, &ask->who, ask->level + 2);
    if (coarser.hold != CELL_HOLDS)
        return;
    const struct indirect_share more = corners_flat_share(&coarser);
    indirect_share_mix(share, &more,
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
        indirect_share_mix(share, &coarse, blend);
    }
    return true;
}

/* What stands for corners is asked in no other way. */
static bool clipped_light(const struct corners at[2], const struct asking *ask,
                          struct indirect_share *share)
{
    if (!corner_cell_whole(ask->who.store, ask->who.worker, at[0].cell,
                           ask->who.receiver))
        return false;
    *share = corners_flat_share(&at[0]);
    if (ask->blend > 0 && at[1].hold >= CELL_HOLDS &&
        corner_cell_whole(ask->who.store, ask->who.worker, at[1].cell,
                          ask->who.receiver)) {
        const struct indirect_share coarse = corners_flat_share(&at[1]);
        indirect_share_mix(share, &coarse, ask->blend);
    }
    return true;
}

/* By corners of the level, or blocks, or the receiver alone. */
static bool fine_light(struct corners at[2], const struct asking *ask,
                       struct indirect_share *share)
{
    corners_begin(&at[0], &ask->who, ask->level);
    if (at[0].hold == CELL_CLIPPED ? clipped_light(at, ask, share)
                                   : cells_light(at, ask->blend, share))
        return true;
    corners_find(&at[0], &ask->who, false);
    if (at[0].sum < indirect_pixels_enough)
        return lone_light(ask, share);
    if (at[1].hold == CELL_HOLDS) {
        corners_find(&at[1], &ask->who, true);
        corners_ask(&at[1], &ask->who);
    }
    corners_ask(&at[0], &ask->who);
    return corners_blend(at, ask, share) || lone_light(ask, share);
}

static bool grid_light(const struct asking *ask, struct indirect_share *share)
{
    struct corners at[2];
    struct indirect_share coarse;
    corners_begin(&at[1], &ask->who, ask->level + 1);
    double enough = coarse_light(&at[1], ask, &coarse);
    if (enough > 0 && at[1].hold == CELL_HOLDS)
        coarse_blend(ask, &coarse);
    if (enough >= 1)
        *share = coarse;
    else if (!fine_light(at, ask, share))
        return false;
    else if (enough > 0)
        indirect_share_mix(share, &coarse, enough);
    return true;
}

bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    struct asking ask = { .pixels = pixels,
                          .who = { pixels->store[receiver->far_side], worker,
                                   receiver } };
    if (indirect_mesh_leaves(pixels->mesh, receiver))
        return false;
    if (receiver->pixel &&
        pixel_answers_find(pixels->answers, worker, receiver, share))
        return true;
    ask.level = surface_grid_level(&pixels->grid, receiver, &ask.blend);
    if (!grid_light(&ask, share))
        return false;
    if (receiver->pixel)
        pixel_answers_keep(pixels->answers, worker, receiver,
                           answer_reach * pixels->grid.step[ask.level], share);
    return true;
}
