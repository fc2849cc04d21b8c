/* Indirect light at a grid of the picture: see indirect_pixels.h. */
#include "lightmesh/indirect_pixels.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/corner.h"
#include "lightmesh/pixel_blocks.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "shade/first_hits.h"
#include "shade/shadow.h"
#include "shade/surface.h"

/* The corners around a place of the grid. */
struct cell {
    uint64_t key; /* of the first, its step with it; 0: of none */
    const struct corner *corner[4];      /* NULL: not asked yet, or not kept */
    const struct corner_light *light[4]; /* likewise */
};

enum { CELLS_ACROSS = 8, CELLS_DOWN = 2, CELL_STEPS = 2 };

/* The last that a worker came by: neighbouring pixels have the same. */
struct cells {
    struct cell at[CELL_STEPS][CELLS_DOWN][CELLS_ACROSS];
};

struct indirect_pixels {
    const struct indirect_mesh *mesh;
    const struct camera *camera;
    double width, height; /* of the picture, in steps of the grid */
    uint64_t columns;
    struct table *corners; /* where they are, and beside, by the same keys, */
    struct table *lights;  /* what those know that served */
    unsigned threads;
    struct pixel_blocks *blocks;
    struct lone_places *lone; /* of each worker, */
    struct cells *cells;      /* too */
};

/* Where rays of a pixel that has several had to ask for themselves: what they
 * got serves as corners do. The oldest gives way. */
struct lone_places {
    unsigned long long pixel; /* worker_pixel's */
    unsigned count;
    struct {
        struct corner corner;
        struct corner_light light;
        int coarser; /* as of a corner's name */
    } at[LONE_PLACES];
};

struct indirect_pixels *indirect_pixels_new(const struct indirect_mesh *mesh,
                                            const struct camera *camera,
                                            int width, int height,
                                            unsigned threads)
{
    struct indirect_pixels *pixels = memory_new(sizeof *pixels);
    double apart = sqrt((double)width * height / indirect_pixels_most);
    apart = fmin(fmax(apart, indirect_pixels_near), indirect_pixels_far);
    *pixels = (struct indirect_pixels){
        .mesh = mesh,
        .camera = camera,
        .width = width / apart,
        .height = height / apart,
        .columns = (uint64_t)(width / apart) + 4,
        .blocks = pixel_blocks_new(mesh, camera, (int[]){ width, height },
                                   apart, threads),
        .threads = threads,
        .lone = memory_new(threads * LONE_PIXELS * sizeof(struct lone_places)),
        .cells = memory_new(threads * sizeof(struct cells)),
    };
    pixels->corners = table_new_beside(
        &pixels->lights, sizeof(struct corner), INDIRECT_PIXELS_BYTES / 3,
        sizeof(struct corner_light), 2 * INDIRECT_PIXELS_BYTES / 3);
    return pixels;
}

void indirect_pixels_free(struct indirect_pixels *pixels)
{
    if (!pixels)
        return;
    table_free(pixels->lights);
    table_free(pixels->corners);
    pixel_blocks_free(pixels->blocks);
    memory_free(pixels->cells);
    memory_free(pixels->lone);
    memory_free(pixels);
}

size_t indirect_pixels_bytes(const struct indirect_pixels *pixels)
{
    return table_bytes(pixels->corners) + table_bytes(pixels->lights);
}

/* Column and row of a corner, and how much what asks there is worth: see
 * point_mesh_worth. */
struct corner_name {
    int at[2];
    int coarser;
};

/* The number of its records, never 0. */
static uint64_t corner_key(const struct indirect_pixels *pixels,
                           const struct corner_name *name)
{
    uint64_t row = (uint64_t)(name->at[1] + 1),
             column = (uint64_t)(name->at[0] + 1);
    return 1 + (row * pixels->columns + column) * POINT_MESH_WORTHS +
           (uint64_t)name->coarser;
}

/* A record of the table, or else the worker's: to be filled unless
 * TABLE_READY, and published if TABLE_MINE. */
static enum table_state corner_record(struct table *table,
                                      struct worker *worker, uint64_t key,
                                      void **record)
{
    enum table_state state = table_find(table, key, random_mix(key), record);
    if (state == TABLE_NONE)
        *record = arena_alloc(worker->scratch, table_record_size(table));
    return state;
}

static struct cell *cell_get(const struct indirect_pixels *pixels,
                             const struct worker *worker,
                             const struct corner_name *name, int step)
{
    uint64_t key = corner_key(pixels, name) * CELL_STEPS + (uint64_t)step - 1;
    unsigned column = (unsigned)(name->at[0] / step) % CELLS_ACROSS;
    unsigned row = (unsigned)(name->at[1] / step) % CELLS_DOWN;
    struct cell *cell =
        &pixels->cells[worker->number].at[step - 1][row][column];
    if (cell->key != key)
        *cell = (struct cell){ .key = key };
    return cell;
}

/* What the camera sees at the corner. */
static void corner_look(struct corner *corner,
                        const struct indirect_pixels *pixels,
                        const struct corner_name *name,
                        const struct receiver *like)
{
    struct intersection at;
    double x = name->at[0] / pixels->width, y = name->at[1] / pixels->height;
    corner->met = false;
    if (!camera_sees(pixels->camera, x, y))
        return;
    struct ray ray = camera_ray(pixels->camera, x, y);
    if (world_closest(pixels->mesh->points.world, &ray,
                      surface_offset(ray.origin), RAY_CAMERA, &at))
        corner_meet(corner, pixels->mesh, like, &ray, &at);
}

/* *kept: for as long as the picture takes. */
static const struct corner *corner_get(const struct indirect_pixels *pixels,
                                       struct worker *worker,
                                       const struct corner_name *name,
                                       const struct receiver *like,
                                       const struct corner **kept)
{
    void *record;
    enum table_state state = corner_record(pixels->corners, worker,
                                           corner_key(pixels, name), &record);
    if (state != TABLE_NONE)
        *kept = record;
    if (state == TABLE_READY)
        return record;
    corner_look(record, pixels, name, like);
    if (state == TABLE_MINE)
        table_publish(pixels->corners, record);
    return record;
}

/* What it knows, as one of the receivers around that have its worth. */
static const struct corner_light *
corner_lit(const struct indirect_pixels *pixels, struct worker *worker,
           const struct corner_name *name, const struct corner *corner,
           const struct receiver *like, const struct corner_light **kept)
{
    void *record;
    enum table_state state = corner_record(pixels->lights, worker,
                                           corner_key(pixels, name), &record);
    if (state != TABLE_NONE)
        *kept = record;
    if (state == TABLE_READY)
        return record;
    struct receiver receiver = corner_receiver(corner, like, name->coarser);
    corner_ask(record, pixels->mesh, worker, &receiver, pixels->mesh->near);
    if (state == TABLE_MINE)
        table_publish(pixels->lights, record);
    return record;
}

/* The corners around a place that serve it, with their weights. */
struct corners {
    struct cell *cell; /* while they are found */
    int count;
    bool missing; /* another is on another surface */
    double sum;
    struct {
        const struct corner *corner;
        const struct corner_light *light;
        double weight;
    } at[4];
};

/* Number `i` of the cell, by that name. */
static void corners_add(struct corners *corners,
                        const struct indirect_pixels *pixels,
                        struct worker *worker, const struct corner_name *name,
                        int i, const struct receiver *receiver)
{
    struct cell *cell = corners->cell;
    const struct corner *corner = cell->corner[i];
    const struct corner_light *light = cell->light[i];
    if (!corner)
        corner = corner_get(pixels, worker, name, receiver, &cell->corner[i]);
    if (!corner_serves(corner, receiver)) {
        corners->missing = true;
        return;
    }
    if (!light)
        light =
            corner_lit(pixels, worker, name, corner, receiver, &cell->light[i]);
    corners->at[corners->count].corner = corner;
    corners->at[corners->count++].light = light;
}

/* Those of every `step`th row and column of the grid. */
static void corners_find(struct corners *corners,
                         const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver,
                         int step)
{
    double x = receiver->pixel->at[0] * pixels->width / step,
           y = receiver->pixel->at[1] * pixels->height / step;
    double across = x - floor(x), down = y - floor(y);
    const struct corner_name first = { { step * (int)floor(x),
                                         step * (int)floor(y) },
                                       point_mesh_worth(receiver->weight) };
    struct cell own = { .key = 0 };
    corners->cell = worker->number < pixels->threads
                        ? cell_get(pixels, worker, &first, step)
                        : &own;
    corners->count = 0;
    corners->sum = 0;
    corners->missing = false;
    for (int i = 0; i < 4; i++) {
        struct corner_name name = first;
        name.at[0] += i % 2 * step;
        name.at[1] += i / 2 * step;
        double weight =
            (i % 2 ? across : 1 - across) * (i / 2 ? down : 1 - down);
        int count = corners->count;
        if (weight < indirect_pixels_least)
            continue;
        corners_add(corners, pixels, worker, &name, i, receiver);
        if (corners->count == count)
            continue;
        corners->at[count].weight = weight;
        corners->sum += weight;
    }
}

/* Where they differ much something may stand between, seen from the edge. */
static bool corners_alike(const struct corners *corners, double even)
{
    double least = HUGE_VAL, most = 0;
    for (int i = 0; i < corners->count; i++) {
        const struct indirect_share *share = &corners->at[i].light->share;
        double amount =
            rgb_brightness(share->light) + indirect_pixels_open * share->open;
        least = fmin(least, amount);
        most = fmax(most, amount);
    }
    return most - least <= even * (most + indirect_pixels_dim);
}

/* Where another surface is near, a wall seen from its edge may stand between
 * all corners and the place. */
static bool corners_see(const struct corners *corners,
                        const struct indirect_pixels *pixels,
                        struct worker *worker, const struct receiver *receiver)
{
    int heaviest = 0, count = corners->count;
    if (corners_alike(corners, indirect_pixels_even)) {
        for (int i = 1; i < count; i++)
            if (corners->at[i].weight > corners->at[heaviest].weight)
                heaviest = i;
        return !corners->missing || count > 2 ||
               corner_sees(corners->at[heaviest].corner, pixels->mesh, worker,
                           receiver);
    }
    for (int i = 0; i < count; i++)
        if (!corner_sees(corners->at[i].corner, pixels->mesh, worker, receiver))
            return false;
    return true;
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

/* By a place of the same pixel that serves the receiver: known, or itself. */
static struct indirect_share lone_share(const struct indirect_pixels *pixels,
                                        struct worker *worker,
                                        const struct receiver *receiver)
{
    unsigned long long pixel = receiver->pixel->pixel;
    struct lone_places *lone =
        &pixels->lone[worker->number * LONE_PIXELS + pixel % LONE_PIXELS];
    int coarser = point_mesh_worth(receiver->weight);
    if (lone->pixel != pixel)
        lone->count = 0;
    lone->pixel = pixel;
    for (unsigned i = 0; i < lone->count && i < LONE_PLACES; i++)
        if (lone->at[i].coarser == coarser &&
            corner_serves(&lone->at[i].corner, receiver))
            return corner_share(&lone->at[i].corner, &lone->at[i].light,
                                receiver);
    unsigned next = lone->count++ % LONE_PLACES;
    lone->at[next].coarser = coarser;
    corner_here(&lone->at[next].corner, pixels->mesh, receiver);
    corner_ask(&lone->at[next].light, pixels->mesh, worker, receiver,
               pixels->mesh->near / NEAR_LONE_PART);
    return corner_share(&lone->at[next].corner, &lone->at[next].light,
                        receiver);
}

/* Where the grid's corners are on other surfaces: pixels of a block share, or
 * else rays of a pixel. */
static bool lone_light(const struct indirect_pixels *pixels,
                       struct worker *worker, const struct receiver *receiver,
                       struct indirect_share *share)
{
    if (pixel_blocks_light(pixels->blocks, worker, receiver, share))
        return true;
    if (!receiver->pixel->pixel || worker->number >= pixels->threads)
        return false;
    *share = lone_share(pixels, worker, receiver);
    return true;
}

/* Whether corners twice as far apart say all that there is to say. */
static bool corners_suffice(const struct corners *corners)
{
    return !corners->missing && corners_alike(corners, indirect_pixels_same);
}

bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    struct corners corners;
    if (!receiver->pixel || indirect_mesh_leaves(pixels->mesh, receiver))
        return false;
    corners_find(&corners, pixels, worker, receiver, 2);
    if (!corners_suffice(&corners)) {
        corners_find(&corners, pixels, worker, receiver, 1);
        if (corners.sum < indirect_pixels_enough ||
            !corners_see(&corners, pixels, worker, receiver))
            return lone_light(pixels, worker, receiver, share);
    }
    *share = receiver_is_bumpy(receiver)
                 ? corners_bumpy(&corners, receiver->normal)
                 : corners_smooth(&corners);
    return true;
}
