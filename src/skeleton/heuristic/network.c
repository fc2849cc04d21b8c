/* The network heuristic: pieces of the skeleton's chambers exchange light until
 * all is in balance (enclosure.h), each by the six ways its walls face. What
 * lamps give to walls is asked by shadow rays from points of all patches, what
 * walls see of each other by rays between them (exchange.h). A surface gets the
 * light of the walls around it that face as it does; light from one piece to
 * the next changes linearly over the width of a cell. */
#include "base/draw.h"
#include "base/memory.h"
#include "base/warp.h"
#include "shade/emitters.h"
#include "shade/shadow.h"
#include "shade/surface.h"
#include "skeleton/exchange.h"
#include "skeleton/heuristic.h"
#include "skeleton/shore.h"
#include "skeleton/spread.h"
#include "skeleton/stream.h"

enum { LOOKS = 128 }; /* rays that tell where light comes from */

/* Irradiance by the side that a surface faces. */
struct side_light {
    rgb side[SIDES];
    bool known[SIDES]; /* whether there is such a wall */
    rgb mean;          /* of all walls */
};

struct network {
    struct arena *arena;
    struct sight sight;
    const struct pieces *pieces;
    const struct enclosure *enclosure;
    struct side_light *light; /* of each piece */
    rgb sky[SIDES];           /* irradiance of the open sky */
    struct shore *shore;      /* of voxels' middles, as far as asked for */
};

/* The light of a piece: of its walls. */
static struct side_light network_piece(const struct enclosure *enclosure,
                                       uint32_t piece)
{
    struct side_light light = { .mean = rgb_grey(0) };
    double area = 0;
    for (int side = 0; side < SIDES; side++) {
        const struct zone *zone = &enclosure->zones[zone_of(piece, side)];
        light.side[side] = zone->light;
        light.known[side] = zone->area > 0;
        light.mean = rgb_add_scaled(light.mean, zone->light, zone->area);
        area += zone->area;
    }
    light.mean = rgb_scale(light.mean, area > 0 ? 1 / area : 0);
    return light;
}

/* Pieces without any walls, in the middle of the void, have the light of those
 * around them. */
static void network_fill(struct network *network, const struct voxels *voxels)
{
    size_t count = network->pieces->count;
    struct piece_light *light = memory_new(count * sizeof *light);
    for (size_t i = 0; i < count; i++) {
        light[i].light = network->light[i].mean;
        for (int side = 0; side < SIDES; side++)
            light[i].known |= network->light[i].known[side];
    }
    spread_light(network->pieces, voxels, light);
    for (size_t i = 0; i < count; i++)
        network->light[i].mean = light[i].light;
    memory_free(light);
}

static void network_solve(struct network *network,
                          const struct skeleton *skeleton)
{
    const struct patches_scene *scene = &network->sight.scene;
    size_t count = network->pieces->count;
    struct patches *patches = patches_new(skeleton->voxels, scene);
    struct enclosure *enclosure = enclosure_new(network->arena, SIDES * count);
    exchange_measure(&network->sight, patches, enclosure);
    patches_free(patches);
    enclosure_solve(enclosure);
    network->enclosure = enclosure;
    network->light = ARENA_ARRAY(network->arena, struct side_light, count);
    for (uint32_t i = 0; i < count; i++)
        network->light[i] = network_piece(enclosure, i);
    network_fill(network, skeleton->voxels);
}

static rgb sky_irradiance(const struct skeleton *skeleton, int side)
{
    rgb sum = rgb_grey(0);
    for (uint32_t i = 0; i < LOOKS; i++) {
        struct draws draws = { random_key(skeleton->seed, (uint64_t)side), i };
        double u[2];
        draw_pair(&draws, 0, u);
        vec3 direction = warp_lobe(u, side_normal(side), 1);
        sum = rgb_add(sum, ambience_beyond(&skeleton->ambience, direction));
    }
    return rgb_scale(sum, 1.0 / LOOKS);
}

static void *network_start(const struct skeleton *skeleton)
{
    struct arena *arena = arena_new(0);
    struct network *network = ARENA_NEW(arena, struct network);
    struct emitters *emitters = emitters_new(skeleton->world, true);
    struct patches_scene scene = {
        .world = skeleton->world,
        .emitters = emitters,
        .ambience = &skeleton->ambience,
        .lamps = skeleton->plain_lamps,
        .lamp_count = skeleton->lamp_count,
        .seed = skeleton->seed,
        .threads = skeleton->threads,
        .stop = skeleton->stop,
    };
    network->arena = arena;
    network->pieces = pieces_new(arena, skeleton->voxels, skeleton->nearest,
                                 skeleton->graph, skeleton->root);
    network->sight = (struct sight){ skeleton, network->pieces, scene };
    network_solve(network, skeleton);
    network->sight.scene.emitters = NULL;
    emitters_free(emitters);
    network->shore = shore_new(skeleton->voxels);
    for (int side = 0; side < SIDES; side++)
        network->sky[side] = sky_irradiance(skeleton, side);
    return network;
}

static void network_finish(void *state)
{
    struct network *network = state;
    shore_free(network->shore);
    arena_free(network->arena);
}

/* Light of walls that face as the normal does: sides weigh as much as it is
 * towards them, in all 1 if there are such walls. Returns the weight. */
static double side_add(const struct side_light *light, vec3 normal,
                       double weight, rgb *sum)
{
    double total = 0;
    for (int axis = 0; axis < 3; axis++) {
        double n = vec3_component(normal, axis);
        int side = 2 * axis + (n < 0);
        if (n == 0 || !light->known[side])
            continue;
        total += weight * n * n;
        *sum = rgb_add_scaled(*sum, light->side[side], weight * n * n);
    }
    return total;
}

static rgb network_outside(const struct skeleton *skeleton, vec3 normal)
{
    const struct network *network = skeleton->state;
    rgb sum = rgb_grey(0);
    for (int axis = 0; axis < 3; axis++) {
        double n = vec3_component(normal, axis);
        sum = rgb_add_scaled(sum, network->sky[2 * axis + (n < 0)], n * n);
    }
    return sum;
}

/* The piece that is so many voxels away, if there is nothing but void between;
 * or PIECE_NONE. */
static uint32_t piece_seen(const struct pieces *pieces, const struct voxels *v,
                           const double from[3], const double by[3])
{
    double most = fmax(fabs(by[0]), fmax(fabs(by[1]), fabs(by[2])));
    int steps = (int)most + 1, at[3];
    uint32_t piece = PIECE_NONE;
    for (int i = 0; i <= steps; i++) {
        for (int axis = 0; axis < 3; axis++)
            at[axis] = (int)floor(from[axis] + by[axis] * i / steps);
        if (!voxels_holds(v, at))
            return PIECE_NONE;
        piece = pieces->of_voxel[voxels_index(v, at[0], at[1], at[2])];
        if (piece == PIECE_NONE)
            return PIECE_NONE;
    }
    return piece;
}

/* Where no wall of the cells around faces that way: those a cell away on all
 * sides; or the mean of all walls. */
static rgb network_beside(const struct skeleton *skeleton, uint32_t own,
                          const double from[3], vec3 normal)
{
    const struct network *network = skeleton->state;
    const struct pieces *pieces = network->pieces;
    const struct piece_cells *cells = &pieces->cells[pieces->region[own]];
    double total = 0;
    rgb sum = rgb_grey(0);
    for (int side = 0; side < SIDES; side++) {
        double by[3] = { 0 }, size = cells->size[side / 2];
        by[side / 2] = side % 2 ? -size : size;
        uint32_t piece = piece_seen(pieces, skeleton->voxels, from, by);
        if (piece != PIECE_NONE)
            total += side_add(&network->light[piece], normal, 1, &sum);
    }
    return total > 0 ? rgb_scale(sum, 1 / total) : network->light[own].mean;
}

/* The cells around a place, each with its share of it (trilinear); first the
 * one that it is in. Those that aren't seen are PIECE_NONE. */
struct corners {
    uint32_t piece[8];
    double weight[8];
};

/* False if there is no cell. `from` is in voxels. */
static bool network_corners(const struct skeleton *skeleton,
                            const double from[3], struct corners *corners)
{
    const struct network *network = skeleton->state;
    const struct pieces *pieces = network->pieces;
    const struct voxels *v = skeleton->voxels;
    double part[3], step[3], by[3] = { 0 };
    uint32_t own = piece_seen(pieces, v, from, by);
    if (own == PIECE_NONE)
        return false;
    const struct piece_cells *cells = &pieces->cells[pieces->region[own]];
    for (int axis = 0; axis < 3; axis++) {
        double size = cells->size[axis];
        double at = (from[axis] - cells->low[axis]) / size;
        double voxel = (floor(from[axis]) + 0.5 - cells->low[axis]) / size;
        double off = at - floor(voxel) - 0.5;
        part[axis] = fabs(off);
        step[axis] = copysign(cells->size[axis] / 2, off);
    }
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        for (int axis = 0; axis < 3; axis++) {
            bool next = corner >> axis & 1;
            by[axis] = next ? step[axis] : 0;
            weight *= next ? part[axis] : 1 - part[axis];
        }
        corners->weight[corner] = weight;
        corners->piece[corner] = own;
        if (corner && weight > 0)
            corners->piece[corner] = piece_seen(pieces, v, from, by);
    }
    return true;
}

/* As side_add, of those that are seen. */
static double corners_add(const struct network *network,
                          const struct corners *corners, vec3 normal, rgb *sum)
{
    double total = 0;
    for (int i = 0; i < 8; i++)
        if (corners->piece[i] != PIECE_NONE)
            total += side_add(&network->light[corners->piece[i]], normal,
                              corners->weight[i], sum);
    return total;
}

/* The mean over the cells around the point, each by its share. */
static rgb network_indirect(const struct skeleton *skeleton,
                            const struct skeleton_point *point)
{
    const struct network *network = skeleton->state;
    const struct voxels *v = skeleton->voxels;
    vec3 place = vec3_scale(vec3_sub(point->around, v->origin), 1 / v->edge);
    double from[3] = { place.x, place.y, place.z };
    struct corners corners;
    rgb sum = rgb_grey(0);
    if (!network_corners(skeleton, from, &corners))
        return sum;
    double total = corners_add(network, &corners, point->normal, &sum);
    uint32_t own = corners.piece[0];
    if (!(total > 0))
        total = side_add(&network->light[own], point->normal, 1, &sum);
    return total > 0 ? rgb_scale(sum, 1 / total)
                     : network_beside(skeleton, own, from, point->normal);
}

/* The light of one side of a voxel, at its middle. If no wall of the cells
 * around faces that way it is that from farther away, and counts nothing beside
 * that of others. */
static struct shore_light network_voxel(const struct skeleton *skeleton,
                                        size_t voxel, int side)
{
    const struct network *network = skeleton->state;
    struct shore_light light = { rgb_grey(0), 0 };
    struct corners corners;
    int at[3];
    if (shore_known(network->shore, voxel, side, &light))
        return light;
    voxels_place(skeleton->voxels, voxel, at);
    double from[3] = { at[0] + 0.5, at[1] + 0.5, at[2] + 0.5 };
    corners.piece[0] = PIECE_NONE;
    if (network_corners(skeleton, from, &corners))
        light.weight =
            corners_add(network, &corners, side_normal(side), &light.light);
    if (light.weight > 0)
        light.light = rgb_scale(light.light, 1 / light.weight);
    else if (corners.piece[0] != PIECE_NONE)
        light.light =
            network_beside(skeleton, corners.piece[0], from, side_normal(side));
    shore_keep(network->shore, voxel, side, &light);
    return light;
}

static rgb network_close(const struct skeleton *skeleton,
                         const struct skeleton_point *point)
{
    double total = 0;
    rgb sum = rgb_grey(0), beside = rgb_grey(0);
    for (int axis = 0; axis < 3; axis++) {
        double n = vec3_component(point->normal, axis);
        if (n == 0)
            continue;
        struct shore_light light =
            network_voxel(skeleton, point->voxel, 2 * axis + (n < 0));
        total += n * n * light.weight;
        sum = rgb_add_scaled(sum, light.light, n * n * light.weight);
        beside = rgb_add_scaled(beside, light.light, n * n);
    }
    return total > 0 ? rgb_scale(sum, 1 / total) : beside;
}

static rgb network_seen(const struct skeleton *skeleton, const struct ray *ray,
                        uint64_t key, double *distance)
{
    const struct network *network = skeleton->state;
    struct sighting seen =
        sight_zone(&network->sight, ray, surface_offset(ray->origin), key);
    *distance = seen.distance;
    if (seen.zone >= ZONE_SKY)
        return seen.beyond;
    return rgb_add_scaled(seen.veil, network->enclosure->zones[seen.zone].sent,
                          seen.clear);
}

static const struct pieces *network_pieces(const struct skeleton *skeleton)
{
    const struct network *network = skeleton->state;
    return network->pieces;
}

/* A ray from the point, above the surface if it is on one, and what it meets.
 */
static rgb network_look(const struct skeleton *skeleton,
                        const struct skeleton_point *point, uint32_t number,
                        vec3 *direction)
{
    struct draws draws = { random_key(skeleton->seed, point->node), number };
    double u[2], distance;
    draw_pair(&draws, 0, u);
    struct ray ray = { point->position, warp_sphere(u) };
    double below = vec3_dot(ray.direction, point->normal);
    if (below < 0)
        ray.direction = vec3_along(ray.direction, point->normal, -2 * below);
    *direction = ray.direction;
    return network_seen(skeleton, &ray, random_key(draws.key, number),
                        &distance);
}

/* The vector irradiance of walls and sky: 1/pi of the integral over all
 * directions of radiance * direction (stream); and what a surface gets that
 * faces it. */
static rgb network_stream(const struct skeleton *skeleton,
                          const struct skeleton_point *point, vec3 *stream)
{
    rgb radiance[LOOKS], sum = rgb_grey(0);
    vec3 direction[LOOKS];
    bool surface = vec3_dot(point->normal, point->normal) > 0;
    double weight = (surface ? 2.0 : 4.0) / LOOKS;
    for (uint32_t i = 0; i < LOOKS; i++) {
        radiance[i] = network_look(skeleton, point, i, &direction[i]);
        *stream = vec3_along(*stream, direction[i],
                             weight * rgb_brightness(radiance[i]));
    }
    vec3 facing = vec3_normalise(*stream);
    for (int i = 0; i < LOOKS; i++)
        sum = rgb_add_scaled(sum, radiance[i],
                             weight * fmax(0, vec3_dot(direction[i], facing)));
    return sum;
}

static struct skeleton_light network_answer(const struct skeleton *skeleton,
                                            struct worker *worker,
                                            const struct skeleton_point *point)
{
    struct skeleton_light light = stream_gather(skeleton, worker, point, NULL);
    rgb facing = network_stream(skeleton, point, &light.stream);
    light.arriving = rgb_add(light.arriving, facing);
    light.indirect = network_indirect(skeleton, point);
    return light;
}

const struct heuristic network_heuristic = {
    .name = "network",
    .help = "by the balance of light between the walls of the void",
    .wayless = true,
    .start = network_start,
    .finish = network_finish,
    .answer = network_answer,
    .indirect = network_indirect,
    .close = network_close,
    .seen = network_seen,
    .pieces = network_pieces,
    .outside = network_outside,
};
