/* Lamps in the void and outside: see entrance.h. */
#include "skeleton/entrance.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "shade/shadow.h"
#include "shade/surface.h"
#include "skeleton/heuristic.h"
#include "skeleton/stream.h"

enum {
    SEARCH = 3,             /* voxels around a lamp that stands in matter */
    PATHS_BYTES = 64 << 20, /* of all ways together */
    NODE_BYTES = 12,        /* of a way, for each node */
    OUTSIDE_RAYS = 2000000, /* from nodes to lamps outside, about */
    CHUNK = 64              /* nodes or lamps that a thread does at once */
};

/* How many different ways there is memory for; at least one. */
static size_t paths_most(const struct skeleton *skeleton)
{
    return PATHS_BYTES / (NODE_BYTES * (skeleton->graph->count + 1)) + 1;
}

/* The node of a lamp that stands in the void, or GRAPH_NONE. */
static uint32_t lamp_node(const struct skeleton *skeleton,
                          const struct lamp *lamp)
{
    struct skeleton_point point = { .position = lamp->light->location,
                                    .node = GRAPH_NONE };
    if (lamp_is_parallel(lamp))
        return GRAPH_NONE;
    if (!skeleton_search(skeleton, 0, &point))
        skeleton_search(skeleton, SEARCH, &point);
    return point.node;
}

/* Of the nodes that own lamps, all, or so many at even steps. */
static size_t nodes_choose(const uint32_t *node_of, size_t lamps, size_t nodes,
                           size_t most, uint32_t *chosen)
{
    uint8_t *owns = memory_new(nodes);
    size_t count = 0, seen = 0, left = 0;
    for (size_t i = 0; i < lamps; i++)
        if (node_of[i] != GRAPH_NONE)
            owns[node_of[i]] = 1;
    for (size_t i = 0; i < nodes; i++)
        count += owns[i];
    for (size_t i = 0; i < nodes; i++) {
        if (!owns[i])
            continue;
        if (count <= most || seen * most / count >= left)
            chosen[left++] = (uint32_t)i;
        seen++;
    }
    memory_free(owns);
    return left;
}

/* The ways of lamps in the void: each from the closest of the chosen nodes. */
static void lamps_within(struct skeleton *skeleton, const uint32_t *node_of)
{
    size_t nodes = skeleton->graph->count;
    uint32_t *chosen = memory_new(nodes * sizeof *chosen);
    const struct paths **known = memory_new(nodes * sizeof(struct paths *));
    struct arena *scratch = arena_new(0);
    struct paths_from all = { .sources = chosen };
    all.count = nodes_choose(node_of, skeleton->lamp_count, nodes,
                             paths_most(skeleton), chosen);
    const struct paths *closest = paths_new(scratch, skeleton->graph, &all);
    for (size_t i = 0; i < skeleton->lamp_count && !skeleton_stopped(skeleton);
         i++) {
        if (node_of[i] == GRAPH_NONE)
            continue;
        uint32_t node = stream_source(closest, node_of[i]);
        struct paths_from from = { .sources = &node, .count = 1 };
        if (!known[node])
            known[node] = paths_new(skeleton->arena, skeleton->graph, &from);
        skeleton->lamps[i].paths = known[node];
    }
    arena_free(scratch);
    memory_free(known);
    memory_free(chosen);
}

/* Which nodes a lamp outside lights. */
struct lighting_up {
    const struct skeleton *skeleton;
    const struct lamp *lamp;
    uint8_t *lit;
};

static bool node_is_lit(const struct skeleton *skeleton,
                        const struct lamp *lamp, size_t node)
{
    struct worker worker = { 0 };
    struct lamp_view view;
    vec3 position = skeleton->graph->nodes[node].position;
    if (!lamp_look(lamp, lamp->light->location, position, &view))
        return false;
    struct shadow_path path = { .point = position,
                                .direction = view.direction,
                                .distance = view.distance,
                                .light = lamp->number };
    return lamp->light->shadowless ||
           rgb_peak(shadow_visibility(skeleton->world, &worker, &path)) > 0;
}

static void light_nodes(void *context, size_t item, unsigned thread)
{
    struct lighting_up *up = context;
    size_t nodes = up->skeleton->graph->count, end = (item + 1) * CHUNK;
    (void)thread;
    for (size_t i = item * CHUNK; i < end && i < nodes; i++)
        up->lit[i] = node_is_lit(up->skeleton, up->lamp, i);
}

/* From outside light comes in at all nodes that see the lamp. */
static const struct paths *lamp_enter(struct skeleton *skeleton,
                                      const struct lamp *lamp)
{
    size_t nodes = skeleton->graph->count;
    uint32_t *sources = memory_new(nodes * sizeof *sources);
    struct lighting_up up = { skeleton, lamp, memory_new(nodes) };
    struct paths_from from = { .sources = sources };
    parallel_run(skeleton->threads, (nodes + CHUNK - 1) / CHUNK, skeleton->stop,
                 light_nodes, &up);
    for (uint32_t i = 0; i < nodes; i++)
        if (up.lit[i])
            sources[from.count++] = i;
    const struct paths *paths =
        from.count > 0 ? paths_new(skeleton->arena, skeleton->graph, &from)
                       : NULL;
    memory_free(up.lit);
    memory_free(sources);
    return paths;
}

/* From the middle of the void to the lamp. */
static vec3 lamp_way(const struct skeleton *skeleton, const struct lamp *lamp)
{
    struct box3 box = voxels_box(skeleton->voxels);
    vec3 middle = vec3_mix(box.low, box.high, 0.5);
    struct lamp_view view;
    lamp_look(lamp, lamp->light->location, middle, &view);
    return view.direction;
}

/* Of the lamps that entered, the one from about the same direction. */
static const struct paths *lamp_alike(const struct skeleton *skeleton,
                                      const size_t *entered, size_t count,
                                      const struct lamp *lamp)
{
    vec3 way = lamp_way(skeleton, lamp);
    const struct paths *best = NULL;
    double most = -2;
    for (size_t i = 0; i < count; i++) {
        const struct skeleton_lamp *other = &skeleton->lamps[entered[i]];
        double alike = vec3_dot(way, lamp_way(skeleton, other->lamp));
        if (alike > most) {
            most = alike;
            best = other->paths;
        }
    }
    return best;
}

/* All of them, or so many at even steps, for whose rays there is time. */
static void lamps_outside(struct skeleton *skeleton)
{
    size_t nodes = skeleton->graph->count, count = 0, seen = 0, left = 0;
    size_t most = OUTSIDE_RAYS / (nodes + 1) + 1;
    size_t *entered = memory_new(skeleton->lamp_count * sizeof *entered);
    uint8_t *done = memory_new(skeleton->lamp_count);
    most = most < paths_most(skeleton) ? most : paths_most(skeleton);
    for (size_t i = 0; i < skeleton->lamp_count; i++)
        count += !skeleton->lamps[i].within;
    for (size_t i = 0; i < skeleton->lamp_count && !skeleton_stopped(skeleton);
         i++) {
        struct skeleton_lamp *lamp = &skeleton->lamps[i];
        if (lamp->within || (count > most && seen++ * most / count < left))
            continue;
        lamp->paths = lamp_enter(skeleton, lamp->lamp);
        entered[left++] = i;
        done[i] = 1;
    }
    for (size_t i = 0; i < skeleton->lamp_count && !skeleton_stopped(skeleton);
         i++) {
        struct skeleton_lamp *lamp = &skeleton->lamps[i];
        if (!lamp->within && !done[i])
            lamp->paths = lamp_alike(skeleton, entered, left, lamp->lamp);
    }
    memory_free(done);
    memory_free(entered);
}

/* Fading is taken for that of power 2, which is next to the true one where
 * there is much light. */
static struct lamp_gist lamp_gist(const struct lamp *lamp)
{
    const struct light *light = lamp->light;
    double reach = light->fade_distance;
    return (struct lamp_gist){
        .x = (float)light->location.x,
        .y = (float)light->location.y,
        .z = (float)light->location.z,
        .brightness = (float)rgb_brightness(light->colour),
        .fading = lamp->fades ? (float)(1 / (reach * reach)) : 0,
    };
}

void skeleton_light_up(struct skeleton *skeleton)
{
    const struct light *lights =
        world_lights(skeleton->world, &skeleton->lamp_count);
    size_t count = skeleton->lamp_count;
    uint32_t *node_of = memory_new(count * sizeof *node_of);
    skeleton->lamps = ARENA_ARRAY(skeleton->arena, struct skeleton_lamp, count);
    skeleton->gists = ARENA_ARRAY(skeleton->arena, struct lamp_gist, count);
    skeleton->plain_lamps = ARENA_ARRAY(skeleton->arena, struct lamp, count);
    for (size_t i = 0; i < count; i++) {
        struct skeleton_lamp *lamp = &skeleton->lamps[i];
        skeleton->plain_lamps[i] = lamp_new(&lights[i], (int)i);
        lamp->lamp = &skeleton->plain_lamps[i];
        skeleton->gists[i] = lamp_gist(lamp->lamp);
        node_of[i] = lamp_node(skeleton, lamp->lamp);
        lamp->within = node_of[i] != GRAPH_NONE;
    }
    if (!skeleton->heuristic->wayless && skeleton->graph->count > 0) {
        lamps_within(skeleton, node_of);
        lamps_outside(skeleton);
    }
    memory_free(node_of);
}
