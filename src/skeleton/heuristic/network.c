/* The network heuristic: the skeleton's chambers exchange light through their
 * openings until all is in balance (enclosure.h; coupled rooms in acoustics do
 * the same). What lamps give to walls is asked by shadow rays from points of
 * all patches. Between chambers light changes over the width of the opening. */
#include "base/memory.h"
#include "skeleton/chamber.h"
#include "skeleton/enclosure.h"
#include "skeleton/heuristic.h"
#include "skeleton/stream.h"
#include "skeleton/patches.h"

struct network {
    struct arena *arena;
    const struct chambers *chambers;
    const struct enclosure *enclosure;
    rgb *light; /* indirect irradiance at each node */
};

static void network_walls(struct network *network, struct enclosure *enclosure,
                          const struct skeleton *skeleton,
                          const struct patches *patches)
{
    for (size_t i = 0; i < patches->count; i++) {
        const struct wall_patch *patch = &patches->items[i];
        uint32_t node = skeleton->nearest[patch->voxel];
        if (node != GRAPH_NONE)
            enclosure_wall(enclosure, network->chambers->of_node[node],
                           (double)patch->area, patch_rgb(patch->albedo),
                           patch_rgb(patch->direct),
                           patch_rgb(patch->emission));
    }
}

/* The face of a void voxel on one side: open to another chamber or the sky. */
static void network_face(struct network *network, struct enclosure *enclosure,
                         const struct skeleton *skeleton, const rgb *sky,
                         size_t voxel, size_t next)
{
    const uint32_t *nearest = skeleton->nearest;
    const uint32_t *chamber = network->chambers->of_node;
    double area = skeleton->voxels->edge * skeleton->voxels->edge;
    if (nearest[voxel] == GRAPH_NONE)
        return;
    uint32_t here = chamber[nearest[voxel]];
    if (sky)
        enclosure_sky(enclosure, here, area, *sky);
    else if (nearest[next] != GRAPH_NONE && chamber[nearest[next]] != here)
        enclosure_open(enclosure, here, chamber[nearest[next]], area);
}

static void network_openings(struct network *network,
                             struct enclosure *enclosure,
                             const struct skeleton *skeleton,
                             const struct patches *patches)
{
    const struct voxels *v = skeleton->voxels;
    for (int z = 0; z < v->size[2]; z++)
        for (int y = 0; y < v->size[1]; y++)
            for (int x = 0; x < v->size[0]; x++) {
                int place[3] = { x, y, z };
                size_t voxel = voxels_index(v, x, y, z), stride = 1;
                for (int axis = 0; axis < 3; axis++) {
                    bool last = place[axis] + 1 == v->size[axis];
                    if (place[axis] == 0)
                        network_face(network, enclosure, skeleton,
                                     &patches->sky[2 * axis], voxel, 0);
                    network_face(network, enclosure, skeleton,
                                 last ? &patches->sky[2 * axis + 1] : NULL,
                                 voxel, voxel + stride);
                    stride *= (size_t)v->size[axis];
                }
            }
}

/* The mean of logarithms; of nothing and something, half of it. */
static double mixed(double a, double b, double share)
{
    if (!(a > 0) || !(b > 0))
        return (1 - share) * a + share * b;
    return a * pow(b / a, share);
}

/* At an opening this chamber and the next weigh the same; as far from it as it
 * is wide, only this one counts. Light falls off by a factor for each length of
 * the way, so between the two it is their logarithms that are mixed. */
static rgb network_blend(const struct network *network,
                         const struct skeleton *skeleton, uint32_t border,
                         rgb own, double distance)
{
    const struct graph *graph = skeleton->graph;
    const uint32_t *chamber = network->chambers->of_node;
    double share = 1 - distance / graph->nodes[border].radius, weight = 1;
    rgb sum = own;
    for (uint32_t k = graph->first[border];
         share > 0 && k < graph->first[border + 1]; k++) {
        uint32_t next = chamber[graph->neighbours[k]];
        rgb there = network->enclosure->chambers[next].light;
        if (next == chamber[border])
            continue;
        weight += share;
        sum = rgb_make(mixed(sum.r, there.r, share / weight),
                       mixed(sum.g, there.g, share / weight),
                       mixed(sum.b, there.b, share / weight));
    }
    return sum;
}

static bool node_is_border(const struct graph *graph, const uint32_t *chamber,
                           uint32_t node)
{
    for (uint32_t k = graph->first[node]; k < graph->first[node + 1]; k++)
        if (chamber[graph->neighbours[k]] != chamber[node])
            return true;
    return false;
}

/* The light of each node: its chamber's, and that beyond the closest opening.
 */
static void network_spread(struct network *network,
                           const struct skeleton *skeleton)
{
    const struct graph *graph = skeleton->graph;
    const uint32_t *chamber = network->chambers->of_node;
    struct arena *scratch = arena_new(0);
    uint32_t *borders = ARENA_ARRAY(scratch, uint32_t, graph->count);
    struct paths_from from = { .sources = borders, .group = chamber };
    for (size_t i = 0; i < graph->count; i++)
        if (node_is_border(graph, chamber, (uint32_t)i))
            borders[from.count++] = (uint32_t)i;
    const struct paths *paths = paths_new(scratch, graph, &from);
    for (size_t i = 0; i < graph->count; i++) {
        rgb own = network->enclosure->chambers[chamber[i]].light;
        network->light[i] = own;
        if (isfinite(paths->distance[i]))
            network->light[i] = network_blend(network, skeleton,
                                              stream_source(paths, (uint32_t)i),
                                              own, (double)paths->distance[i]);
    }
    arena_free(scratch);
}

static void *network_start(const struct skeleton *skeleton)
{
    struct arena *arena = arena_new(0);
    struct network *network = ARENA_NEW(arena, struct network);
    struct patches_scene from = {
        .world = skeleton->world,
        .scene = skeleton->scene,
        .lamps = skeleton->plain_lamps,
        .lamp_count = skeleton->lamp_count,
        .seed = skeleton->seed,
        .threads = skeleton->threads,
    };
    struct patches *patches = patches_new(skeleton->voxels, &from);
    network->arena = arena;
    network->chambers = chambers_new(arena, skeleton->graph);
    struct enclosure *enclosure =
        enclosure_new(arena, network->chambers->count);
    network->enclosure = enclosure;
    network->light = ARENA_ARRAY(arena, rgb, skeleton->graph->count);
    network_walls(network, enclosure, skeleton, patches);
    network_openings(network, enclosure, skeleton, patches);
    patches_free(patches);
    enclosure_solve(enclosure);
    network_spread(network, skeleton);
    return network;
}

static void network_finish(void *state)
{
    struct network *network = state;
    arena_free(network->arena);
}

/* The mean over the nodes of the void voxels around the point, each by its
 * share (trilinear). */
static rgb network_indirect(const struct skeleton *skeleton,
                            const struct skeleton_point *point)
{
    const struct network *network = skeleton->state;
    const struct voxels *v = skeleton->voxels;
    vec3 middle =
        vec3_sub(vec3_scale(vec3_sub(point->around, v->origin), 1 / v->edge),
                 vec3_make(0.5, 0.5, 0.5));
    int low[3] = { (int)floor(middle.x), (int)floor(middle.y),
                   (int)floor(middle.z) };
    double part[3] = { middle.x - low[0], middle.y - low[1],
                       middle.z - low[2] };
    double total = 0;
    rgb sum = rgb_grey(0);
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        int at[3];
        for (int axis = 0; axis < 3; axis++) {
            int up = corner >> axis & 1;
            at[axis] = low[axis] + up;
            weight *= up ? part[axis] : 1 - part[axis];
        }
        uint32_t node = skeleton_node(skeleton, at);
        if (node == GRAPH_NONE || !(weight > 0))
            continue;
        sum = rgb_add_scaled(sum, network->light[node], weight);
        total += weight;
    }
    return total > 0 ? rgb_scale(sum, 1 / total) : network->light[point->node];
}

/* Directions are those of the forward heuristic. */
static struct skeleton_light network_answer(const struct skeleton *skeleton,
                                            struct worker *worker,
                                            const struct skeleton_point *point)
{
    struct skeleton_light light =
        stream_gather(skeleton, worker, point, stream_forward);
    light.arriving = rgb_sub(light.arriving, light.hidden);
    light.indirect = network_indirect(skeleton, point);
    light.arriving = rgb_add(light.arriving, light.indirect);
    return light;
}

const struct heuristic network_heuristic = {
    .name = "network",
    .help = "by the balance of light between the chambers of the void",
    .start = network_start,
    .finish = network_finish,
    .answer = network_answer,
    .indirect = network_indirect,
};
