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

struct indirect_pixels {
    const struct indirect_mesh *mesh;
    const struct camera *camera;
    double width, height; /* of the picture, in steps of the grid */
    uint64_t columns;
    struct table *corners;
    unsigned threads;
    struct pixel_blocks *blocks;
    struct lone_places *lone; /* of each worker */
};

/* Where rays of a pixel that has several had to ask for themselves: what they
 * got serves as corners do. The oldest gives way. */
struct lone_places {
    unsigned long long pixel; /* as the worker has it */
    unsigned count;
    struct {
        struct corner corner;
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
        .corners = table_new(sizeof(struct corner), INDIRECT_PIXELS_BYTES),
        .blocks = pixel_blocks_new(mesh, camera, (int[]){ width, height },
                                   apart, threads),
        .threads = threads,
        .lone = memory_new(threads * sizeof(struct lone_places)),
    };
    return pixels;
}

void indirect_pixels_free(struct indirect_pixels *pixels)
{
    if (!pixels)
        return;
    table_free(pixels->corners);
    pixel_blocks_free(pixels->blocks);
    memory_free(pixels->lone);
    memory_free(pixels);
}

size_t indirect_pixels_bytes(const struct indirect_pixels *pixels)
{
    return table_bytes(pixels->corners);
}

/* Column and row of a corner, and how much what asks there is worth: see
 * point_mesh_worth. */
struct corner_name {
    int at[2];
    int coarser;
};

/* What the camera sees at the corner asks the mesh, as one of the receivers
 * around would that have its worth. */
static void corner_fill(struct corner *corner,
                        const struct indirect_pixels *pixels,
                        struct worker *worker, const struct corner_name *name,
                        const struct receiver *like)
{
    struct intersection at;
    double x = name->at[0] / pixels->width, y = name->at[1] / pixels->height;
    corner->met = false;
    if (!camera_sees(pixels->camera, x, y))
        return;
    struct ray ray = camera_ray(pixels->camera, x, y);
    if (!world_closest(pixels->mesh->points.world, &ray,
                       surface_offset(ray.origin), RAY_CAMERA, &at))
        return;
    struct receiver receiver = corner_receiver(like, &ray, &at, name->coarser);
    corner_place(corner, pixels->mesh, &receiver);
    corner_ask(corner, pixels->mesh, worker, &receiver, pixels->mesh->near);
}

static const struct corner *corner_get(const struct indirect_pixels *pixels,
                                       struct worker *worker,
                                       const struct corner_name *name,
                                       const struct receiver *like)
{
    void *record;
    uint64_t row = (uint64_t)(name->at[1] + 1),
             column = (uint64_t)(name->at[0] + 1);
    uint64_t key = 1 + (row * pixels->columns + column) * POINT_MESH_WORTHS +
                   (uint64_t)name->coarser;
    enum table_state state =
        table_find(pixels->corners, key, random_mix(key), &record);
    if (state == TABLE_READY)
        return record;
    if (state == TABLE_NONE)
        record = arena_alloc(worker->scratch, sizeof(struct corner));
    corner_fill(record, pixels, worker, name, like);
    if (state == TABLE_MINE)
        table_publish(pixels->corners, record);
    return record;
}

/* The corners around a place that serve it, with their weights. */
struct corners {
    int count;
    bool missing; /* another is on another surface */
    double sum;
    struct {
        const struct corner *corner;
        double weight;
    } at[4];
};

static void corners_find(struct corners *corners,
                         const struct indirect_pixels *pixels,
                         struct worker *worker, const struct receiver *receiver)
{
    double x = receiver->pixel->at[0] * pixels->width,
           y = receiver->pixel->at[1] * pixels->height;
    double across = x - floor(x), down = y - floor(y);
    int coarser = point_mesh_worth(receiver->weight);
    corners->count = 0;
    corners->sum = 0;
    corners->missing = false;
    for (int i = 0; i < 4; i++) {
        struct corner_name name = {
            { (int)floor(x) + i % 2, (int)floor(y) + i / 2 }, coarser
        };
        double weight =
            (i % 2 ? across : 1 - across) * (i / 2 ? down : 1 - down);
        if (weight < indirect_pixels_least)
            continue;
        const struct corner *corner =
            corner_get(pixels, worker, &name, receiver);
        if (!corner_serves(corner, receiver)) {
            corners->missing = true;
            continue;
        }
        corners->at[corners->count].corner = corner;
        corners->at[corners->count++].weight = weight;
        corners->sum += weight;
    }
}

/* Whether nothing stands between, a little above the surface. */
static bool corner_sees(const struct indirect_pixels *pixels,
                        struct worker *worker, const struct corner *corner,
                        const struct receiver *receiver)
{
    double apart = vec3_length(vec3_sub(corner->point, receiver->point));
    double lift = indirect_pixels_lift * apart;
    vec3 from = vec3_along(receiver->point, receiver->side, lift);
    vec3 to = vec3_along(corner->point, corner->side, lift);
    vec3 between = vec3_sub(to, from);
    double length = vec3_length(between);
    if (!(length > 0))
        return true;
    struct ray ray = { from, vec3_scale(between, 1 / length) };
    worker->counters.shadow_rays++;
    return !world_occluded(
        pixels->mesh->points.world,
        &(struct occlusion){ .ray = &ray, .tmax = length, .light = -1 });
}

/* Where they differ much something may stand between, seen from the edge. */
static bool corners_alike(const struct corners *corners)
{
    double least = HUGE_VAL, most = 0;
    for (int i = 0; i < corners->count; i++) {
        const struct indirect_share *share = &corners->at[i].corner->share;
        double amount =
            rgb_brightness(share->light) + indirect_pixels_open * share->open;
        least = fmin(least, amount);
        most = fmax(most, amount);
    }
    return most - least <= indirect_pixels_even * most + indirect_pixels_dim;
}

/* Where another surface is near, a wall seen from its edge may stand between
 * all corners and the place. */
static bool corners_see(const struct corners *corners,
                        const struct indirect_pixels *pixels,
                        struct worker *worker, const struct receiver *receiver)
{
    int heaviest = 0, count = corners->count;
    if (corners_alike(corners)) {
        for (int i = 1; i < count; i++)
            if (corners->at[i].weight > corners->at[heaviest].weight)
                heaviest = i;
        return !corners->missing ||
               corner_sees(pixels, worker, corners->at[heaviest].corner,
                           receiver);
    }
    for (int i = 0; i < count; i++)
        if (!corner_sees(pixels, worker, corners->at[i].corner, receiver))
            return false;
    return true;
}

/* Irradiance is interpolated as it is, between corners whose normals follow
 * the surface. */
static struct indirect_share corners_smooth(const struct corners *corners)
{
    struct indirect_share share = { rgb_grey(0), 0 };
    for (int i = 0; i < corners->count; i++) {
        const struct corner *corner = corners->at[i].corner;
        double weight = corners->at[i].weight / corners->sum;
        share.light = rgb_add_scaled(share.light, corner->share.light, weight);
        share.open += weight * corner->share.open;
    }
    return share;
}

/* Bumps take what comes from their own sides. */
static struct indirect_share corners_bumpy(const struct corners *corners,
                                           vec3 normal)
{
    struct indirect_light light = indirect_light_none;
    for (int i = 0; i < corners->count; i++)
        indirect_light_mix(&light, &corners->at[i].corner->light,
                           (float)(corners->at[i].weight / corners->sum));
    return indirect_light_share(&light, normal);
}

/* A place of the same pixel that serves the receiver: known, or itself. */
static const struct corner *lone_get(const struct indirect_pixels *pixels,
                                     struct worker *worker,
                                     const struct receiver *receiver)
{
    struct lone_places *lone = &pixels->lone[worker->number];
    int coarser = point_mesh_worth(receiver->weight);
    if (lone->pixel != worker->pixel)
        lone->count = 0;
    lone->pixel = worker->pixel;
    for (unsigned i = 0; i < lone->count && i < LONE_PLACES; i++)
        if (lone->at[i].coarser == coarser &&
            corner_serves(&lone->at[i].corner, receiver))
            return &lone->at[i].corner;
    unsigned next = lone->count++ % LONE_PLACES;
    lone->at[next].coarser = coarser;
    corner_place(&lone->at[next].corner, pixels->mesh, receiver);
    corner_ask(&lone->at[next].corner, pixels->mesh, worker, receiver,
               pixels->mesh->near / NEAR_LONE_PART);
    return &lone->at[next].corner;
}

/* Where the grid's corners are on other surfaces: pixels of a block share, or
 * else rays of a pixel. */
static bool lone_light(const struct indirect_pixels *pixels,
                       struct worker *worker, const struct receiver *receiver,
                       struct indirect_share *share)
{
    const struct corner *corner =
        pixel_blocks_find(pixels->blocks, worker, receiver);
    if (!corner && worker->pixel && worker->number < pixels->threads)
        corner = lone_get(pixels, worker, receiver);
    if (corner)
        *share = corner_share(corner, receiver);
    return corner;
}

bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share)
{
    struct corners corners;
    if (!receiver->pixel || indirect_mesh_leaves(pixels->mesh, receiver))
        return false;
    corners_find(&corners, pixels, worker, receiver);
    if (corners.sum < indirect_pixels_enough ||
        !corners_see(&corners, pixels, worker, receiver))
        return lone_light(pixels, worker, receiver, share);
    *share = receiver_is_bumpy(receiver)
                 ? corners_bumpy(&corners, receiver->normal)
                 : corners_smooth(&corners);
    return true;
}
