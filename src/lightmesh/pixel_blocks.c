/* Places that the pixels of a block share: see pixel_blocks.h. */
#include "lightmesh/pixel_blocks.h"

#include "base/memory.h"
#include "lightmesh/tuning.h"
#include "shade/first_hits.h"
#include "shade/shadow.h"

enum {
    BLOCK_EDGE = 4, /* places along the edge of a block */
    BLOCK_PLACES = BLOCK_EDGE * BLOCK_EDGE,
    BLOCK_MIDDLE = BLOCK_EDGE + 1, /* one of four */
    KEPT_ACROSS = 16, /* blocks that a worker keeps: those of a few rows */
    KEPT_DOWN = 4,
};

/* To the pixels of the half towards the first place; to those of the other half
 * they are in the opposite order. The middle of a half serves most; corners
 * last. */
static const int place_order[BLOCK_PLACES] = { 5, 10, 6,  9,  1, 2, 4,  7,
                                               8, 11, 13, 14, 0, 3, 12, 15 };

struct block {
    bool looked;
    int at[2]; /* column and row of blocks */
    struct ray rays[BLOCK_PLACES];
    struct world_hit hits[BLOCK_PLACES];
    struct {
        bool placed;
        double footprint; /* distance of places there, units */
        int coarser;      /* as it was asked (point_mesh_worth); -1: not yet */
        struct corner corner;
        struct corner_light light;
        bool deep; /* much is close to it, as under a ball: the next pixel gets
                    * far more light, or less */
    } places[BLOCK_PLACES];
    int coarser; /* as the middle was asked for what the points around know, */
    bool around; /* whether there are any, */
    struct indirect_light light; /* and what that is */
};

struct pixel_blocks {
    const struct indirect_mesh *mesh;
    const struct camera *camera;
    int size[2]; /* of the picture, pixels */
    int step;    /* pixels from place to place */
    unsigned threads;
    struct block *kept; /* of each worker */
};

struct pixel_blocks *pixel_blocks_new(const struct indirect_mesh *mesh,
                                      const struct camera *camera,
                                      const int size[2], double apart,
                                      unsigned threads)
{
    struct pixel_blocks *blocks = memory_new(sizeof *blocks);
    size_t kept = (size_t)threads * KEPT_ACROSS * KEPT_DOWN;
    *blocks = (struct pixel_blocks){
        .mesh = mesh,
        .camera = camera,
        .size = { size[0], size[1] },
        .step = (int)fmax(apart * block_places, 1),
        .threads = threads,
        .kept = memory_new(kept * sizeof *blocks->kept),
    };
    return blocks;
}

void pixel_blocks_free(struct pixel_blocks *blocks)
{
    if (!blocks)
        return;
    memory_free(blocks->kept);
    memory_free(blocks);
}

/* The pixel that a place of the block is in the middle of. */
static void place_pixel(const struct block *block,
                        const struct pixel_blocks *blocks, int number,
                        int pixel[2])
{
    int inside[2] = { number % BLOCK_EDGE, number / BLOCK_EDGE };
    for (int axis = 0; axis < 2; axis++)
        pixel[axis] =
            (block->at[axis] * BLOCK_EDGE + inside[axis]) * blocks->step +
            blocks->step / 2;
}

/* The ray through it. False: the picture shows nothing there. */
static bool block_ray(struct block *block, const struct pixel_blocks *blocks,
                      int number)
{
    double place[2];
    int pixel[2];
    place_pixel(block, blocks, number, pixel);
    for (int axis = 0; axis < 2; axis++)
        place[axis] = (pixel[axis] + 0.5) / blocks->size[axis];
    block->rays[number] = camera_ray(blocks->camera, place[0], place[1]);
    return camera_sees(blocks->camera, place[0], place[1]);
}

/* Whether what all of its rays meet is among that. */
static bool block_is_known(const struct block *block,
                           const struct pixel_blocks *blocks,
                           const struct first_hits *around)
{
    int first[2], last[2];
    if (!around || around->middle != 0.5)
        return false;
    place_pixel(block, blocks, 0, first);
    place_pixel(block, blocks, BLOCK_PLACES - 1, last);
    return first[0] >= around->left && first[1] >= around->top &&
           last[0] < around->left + around->columns &&
           last[1] < around->top + around->rows;
}

/* What it meets, unless that is clear. */
static bool place_is_known(struct block *block,
                           const struct pixel_blocks *blocks, int number,
                           const struct first_hits *around)
{
    int pixel[2];
    place_pixel(block, blocks, number, pixel);
    const struct world_hit *hit = first_hits_at(around, pixel[0], pixel[1]);
    if (first_hit_is_clear(hit))
        return false;
    block->hits[number] = *hit;
    return true;
}

/* What the camera sees through the block: of a small picture those who ask have
 * looked there already. */
static void block_look(struct block *block, const struct pixel_blocks *blocks,
                       const struct first_hits *around)
{
    bool known = block_is_known(block, blocks, around);
    struct rays rays;
    struct world_hit hits[BLOCK_PLACES];
    struct rays_span span;
    int number[BLOCK_PLACES];
    unsigned count = 0;
    block->coarser = -1;
    for (int i = 0; i < BLOCK_PLACES; i++) {
        block->hits[i].leaf = NULL;
        block->places[i].placed = false;
        block->places[i].coarser = -1;
        if (!block_ray(block, blocks, i))
            continue;
        if (known && place_is_known(block, blocks, i, around))
            continue;
        vec3 origin = block->rays[i].origin;
        rays_set(&rays, (int)count, origin, block->rays[i].direction);
        span.near[count] = surface_offset(origin);
        span.far[count] = (double)INFINITY;
        number[count++] = i;
    }
    rays_fill(&rays, &span, count);
    world_closest_many(blocks->mesh->points.world, &rays, &span, count,
                       RAY_SIGHT, hits);
    for (unsigned i = 0; i < count; i++)
        block->hits[number[i]] = hits[i];
}

static struct block *block_get(const struct pixel_blocks *blocks,
                               const struct worker *worker,
                               const struct receiver *receiver)
{
    int at[2];
    for (int axis = 0; axis < 2; axis++)
        at[axis] = (int)floor(receiver->pixel->at[axis] * blocks->size[axis] /
                              (BLOCK_EDGE * blocks->step));
    size_t kept =
        (size_t)worker->number * KEPT_DOWN + (unsigned)at[1] % KEPT_DOWN;
    struct block *block =
        &blocks->kept[kept * KEPT_ACROSS + (unsigned)at[0] % KEPT_ACROSS];
    if (block->looked && block->at[0] == at[0] && block->at[1] == at[1])
        return block;
    block->looked = true;
    block->at[0] = at[0];
    block->at[1] = at[1];
    block_look(block, blocks, receiver->pixel->around);
    return block;
}

/* Where the place is, and how far from the next on a surface that faces it. */
static void place_find(struct block *block, const struct pixel_blocks *blocks,
                       int number, const struct receiver *like)
{
    const struct ray *a = &block->rays[BLOCK_MIDDLE], *b = a + 1;
    const struct ray *ray = &block->rays[number];
    double t = block->hits[number].hit.t;
    struct intersection at;
    world_describe(ray, &block->hits[number], &at);
    corner_meet(&block->places[number].corner, blocks->mesh, like, ray, &at);
    if (like->far_side)
        corner_turn(&block->places[number].corner);
    block->places[number].placed = true;
    block->places[number].footprint =
        vec3_length(vec3_sub(vec3_along(a->origin, a->direction, t),
                             vec3_along(b->origin, b->direction, t)));
}

/* What is close enough may be beside as well: the next blade of grass. */
static bool place_serves(const struct block *block, int number,
                         const struct receiver *receiver)
{
    const struct corner *corner = &block->places[number].corner;
    double apart = vec3_length(vec3_sub(corner->point, receiver->point));
    return vec3_dot(corner->side, receiver->side) >= block_bend &&
           (corner_serves(corner, receiver) ||
            apart <= block_beside * block->places[number].footprint);
}

/* Whether mesh points look alike from there and from the middle: they are much
 * farther off, and no thin wall is between. */
static bool place_is_central(const struct block *block,
                             const struct pixel_blocks *blocks,
                             struct worker *worker, int number,
                             const struct receiver *receiver)
{
    const struct corner *middle = &block->places[BLOCK_MIDDLE].corner;
    double apart = vec3_length(vec3_sub(receiver->point, middle->point));
    if (number == BLOCK_MIDDLE)
        return true;
    return block->places[BLOCK_MIDDLE].placed &&
           apart <= block_around * middle->reach &&
           vec3_dot(receiver->side, middle->side) >= block_around_bend &&
           corner_sees(middle, blocks->mesh, worker, receiver);
}

/* What the points around the middle know, for those places: finding which of
 * them see a place costs as much as looking around there. */
static bool block_ask(struct block *block, const struct pixel_blocks *blocks,
                      struct worker *worker, const struct receiver *like,
                      int coarser)
{
    if (block->coarser == coarser)
        return block->around;
    const struct receiver receiver =
        corner_receiver(&block->places[BLOCK_MIDDLE].corner, like, coarser);
    block->around =
        indirect_mesh_blend(blocks->mesh, worker, &receiver, &block->light);
    block->coarser = coarser;
    return block->around;
}

/* Of short rays: more meet something where it is deep. Where few places are in
 * crevices that is sooner, as such a place gathers itself. */
static double block_deep_from(const struct indirect_mesh *mesh)
{
    return mesh->near_own.count < RAY_LANES ? block_deep : near_deep;
}

static void place_ask(struct block *block, const struct pixel_blocks *blocks,
                      struct worker *worker, int number,
                      const struct receiver *like)
{
    int coarser = point_mesh_worth(like->weight);
    if (block->places[number].coarser == coarser)
        return;
    struct receiver receiver =
        corner_receiver(&block->places[number].corner, like, coarser);
    struct corner_light *light = &block->places[number].light;
    const struct near_ways *ways =
        like->far_side ? &blocks->mesh->near_more : &blocks->mesh->near_lone;
    struct near_share near;
    if (place_is_central(block, blocks, worker, number, &receiver) &&
        block_ask(block, blocks, worker, like, coarser)) {
        light->light = block->light;
        near = indirect_mesh_mend(blocks->mesh, worker, &receiver, ways,
                                  &light->light);
    } else {
        near = indirect_mesh_around(blocks->mesh, worker, &receiver, ways,
                                    &light->light);
    }
    light->share = near.share;
    block->places[number].deep = near.met > block_deep_from(blocks->mesh);
    block->places[number].coarser = coarser;
}

/* Whether the receiver is in the half that ends with the last place. */
static bool block_half(const struct block *block,
                       const struct pixel_blocks *blocks,
                       const struct receiver *receiver)
{
    double along = 0;
    for (int axis = 0; axis < 2; axis++)
        along += receiver->pixel->at[axis] * blocks->size[axis] / blocks->step -
                 block->at[axis] * BLOCK_EDGE;
    return along > BLOCK_EDGE;
}

/* The place whose part of the block the receiver is in. */
static int block_nearest(const struct block *block,
                         const struct pixel_blocks *blocks,
                         const struct receiver *receiver)
{
    int inside[2];
    for (int axis = 0; axis < 2; axis++) {
        double along =
            receiver->pixel->at[axis] * blocks->size[axis] / blocks->step;
        inside[axis] = (int)along - block->at[axis] * BLOCK_EDGE;
        inside[axis] = (int)fmin(fmax(inside[axis], 0), BLOCK_EDGE - 1);
    }
    return inside[1] * BLOCK_EDGE + inside[0];
}

/* Whether it can tell what the receiver gets: then it is asked. */
static bool place_tells(struct block *block, const struct pixel_blocks *blocks,
                        struct worker *worker, int number,
                        const struct receiver *receiver)
{
    if (!block->hits[number].leaf)
        return false;
    if (!block->places[number].placed)
        place_find(block, blocks, number, receiver);
    if (!place_serves(block, number, receiver) ||
        !corner_sees(&block->places[number].corner, blocks->mesh, worker,
                     receiver))
        return false;
    place_ask(block, blocks, worker, number, receiver);
    return true;
}

static struct indirect_share place_share(const struct block *block, int number,
                                         const struct receiver *receiver)
{
    return corner_share(&block->places[number].corner,
                        &block->places[number].light, receiver);
}

bool pixel_blocks_light(const struct pixel_blocks *blocks,
                        struct worker *worker, const struct receiver *receiver,
                        struct indirect_share *share)
{
    if (worker->number >= blocks->threads)
        return false;
    struct block *block = block_get(blocks, worker, receiver);
    bool later = block_half(block, blocks, receiver);
    if (block->hits[BLOCK_MIDDLE].leaf && !block->places[BLOCK_MIDDLE].placed)
        place_find(block, blocks, BLOCK_MIDDLE, receiver);
    for (int i = 0; i < BLOCK_PLACES; i++) {
        int number = later ? BLOCK_PLACES - 1 - place_order[i] : place_order[i];
        if (!place_tells(block, blocks, worker, number, receiver))
            continue;
        int nearest = block_nearest(block, blocks, receiver);
        if (block->places[number].deep &&
            place_tells(block, blocks, worker, nearest, receiver))
            number = nearest;
        *share = place_share(block, number, receiver);
        return true;
    }
    return false;
}
