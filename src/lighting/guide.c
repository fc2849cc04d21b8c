/* Skeleton-guided sampling: see guide.h. The lobe is cos^s around the direction
 * to the barycentre of the nodes that a node sees along its shortest path to
 * the lamp; the normalisation is (s + 1)/(2 pi). Of several lamps each has a
 * share by what the forward heuristic gives for it. How often a lobe is used
 * goes with how directed the stream of light is. */
#include "lighting/guide.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"
#include "lighting/void_skeleton.h"
#include "skeleton/heuristic.h"
#include "skeleton/stream.h"

enum {
    LAMPS_MOST = 256, /* each may need ways of its own */
    HIDDEN_MOST = 8,  /* nodes in a row, after which none is looked for */
    /* A guide may be rough: the skeleton's voxels along the longest side, if
     * the scene names no number, and the rays between its walls. */
    VOXELS = 64,
    WALL_RAYS = 50000
};

/* How often a lobe is used where all light comes from one side, and its s. */
static const double chance_most = 0.5, lobe_power = 4;

/* Where light differs by less, but for a tenth of the nodes at either end, all
 * paths are worth about the same. */
static const double even = 8;

struct target {
    vec3 place;
    double chance; /* of its lobe */
};

/* What a node knows. */
struct node_targets {
    int count;
    struct target at[GUIDE_TARGETS];
    double light; /* indirect irradiance, the largest of the colours */
};

struct guide {
    struct void_skeleton made;
    const struct skeleton *skeleton; /* of `made` */
    struct node_targets *nodes;
    bool useful; /* else nodes have no targets */
    /* Lamps by where their light comes in: the same paths, the same target. */
    size_t *entrance; /* of each lamp */
    const struct skeleton_lamp **entrances;
    size_t entrance_count;
};

void guide_free(struct guide *guide)
{
    if (!guide)
        return;
    memory_free(guide->entrances);
    memory_free(guide->entrance);
    memory_free(guide->nodes);
    void_skeleton_free(&guide->made);
    memory_free(guide);
}

static void guide_find_entrances(struct guide *guide)
{
    const struct skeleton *skeleton = guide->skeleton;
    size_t count = skeleton->lamp_count;
    guide->entrance = memory_new(count * sizeof *guide->entrance);
    guide->entrances = memory_new(count * sizeof *guide->entrances);
    for (size_t i = 0; i < count; i++) {
        size_t k = 0;
        while (k < guide->entrance_count &&
               guide->entrances[k]->paths != skeleton->lamps[i].paths)
            k++;
        if (k == guide->entrance_count)
            guide->entrances[guide->entrance_count++] = &skeleton->lamps[i];
        guide->entrance[i] = k;
    }
}

/* The mean of the nodes on the way to the lamp that this one sees. */
static vec3 importance_point(const struct guide *guide,
                             const struct skeleton_lamp *lamp, uint32_t node)
{
    const struct graph_node *nodes = guide->skeleton->graph->nodes;
    const uint32_t *parent = lamp->paths->parent;
    vec3 from = nodes[node].position, sum = from;
    int seen = 1, hidden = 0;
    for (uint32_t at = parent[node]; at != GRAPH_NONE && hidden < HIDDEN_MOST;
         at = parent[at]) {
        if (!stream_sees(guide->skeleton, from, nodes[at].position)) {
            hidden++;
            continue;
        }
        hidden = 0;
        seen++;
        sum = vec3_add(sum, nodes[at].position);
    }
    return vec3_scale(sum, 1.0 / seen);
}

/* The strongest entrances first; what was taken is 0 then. */
static void node_choose(struct guide *guide, uint32_t node, double *strength,
                        double chance)
{
    struct node_targets *targets = &guide->nodes[node];
    while (targets->count < GUIDE_TARGETS) {
        size_t best = 0;
        for (size_t i = 1; i < guide->entrance_count; i++)
            if (strength[i] > strength[best])
                best = i;
        if (!(strength[best] > 0))
            return;
        targets->at[targets->count++] = (struct target){
            importance_point(guide, guide->entrances[best], node),
            chance * strength[best],
        };
        strength[best] = 0;
    }
}

static struct skeleton_point node_point(const struct skeleton *skeleton,
                                        size_t node)
{
    vec3 position = skeleton->graph->nodes[node].position;
    return (struct skeleton_point){ .position = position,
                                    .around = position,
                                    .voxel = VOXEL_NONE,
                                    .node = (uint32_t)node };
}

static void node_aim(void *context, size_t item, unsigned thread)
{
    struct guide *guide = context;
    const struct skeleton *skeleton = guide->skeleton;
    struct skeleton_point point = node_point(skeleton, item);
    double *strength = memory_new(guide->entrance_count * sizeof *strength);
    double sum = 0;
    vec3 stream = { 0 };
    (void)thread;
    for (size_t i = 0; i < skeleton->lamp_count; i++) {
        struct stream_way way;
        double light = rgb_brightness(stream_hidden(
            skeleton, &skeleton->lamps[i], &point, stream_forward, &way));
        if (!(light > 0) || !isfinite(light))
            continue;
        strength[guide->entrance[i]] += light;
        sum += light;
        stream = vec3_along(stream, way.direction, light);
    }
    if (sum > 0)
        node_choose(guide, (uint32_t)item, strength,
                    chance_most * vec3_length(stream) / (sum * sum));
    memory_free(strength);
}

/* How much light each node has, and whether that differs. */
static void guide_find_light(struct guide *guide)
{
    const struct skeleton *skeleton = guide->skeleton;
    size_t count = skeleton->graph->count, tenth = count / 10;
    double *light = memory_new((count + 1) * sizeof *light);
    for (size_t i = 0; i < count; i++) {
        struct skeleton_point point = node_point(skeleton, i);
        light[i] = rgb_peak(skeleton->heuristic->indirect(skeleton, &point));
        guide->nodes[i].light = light[i];
    }
    qsort(light, count, sizeof *light, order_double);
    guide->useful = count > 0 && light[count - 1 - tenth] > even * light[tenth];
    memory_free(light);
}

bool guide_useful(const struct guide *guide)
{
    return guide->useful;
}

struct guide *guide_new(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    size_t lamps;
    world_lights(world, &lamps);
    if (lamps > LAMPS_MOST) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "--guide skeleton is for up to %d lamps, here are %zu: "
                   "leave it out",
                   LAMPS_MOST, lamps);
        return NULL;
    }
    struct guide *guide = memory_new(sizeof *guide);
    struct void_skeleton_wish wish = { .heuristic = "network",
                                       .resolution = VOXELS,
                                       .ways = true,
                                       .rays = WALL_RAYS };
    if (!void_skeleton_make(&guide->made, world, scene, wish, options, diag)) {
        guide_free(guide);
        return NULL;
    }
    guide->skeleton = guide->made.skeleton;
    size_t nodes = guide->skeleton->graph->count;
    guide->nodes = memory_new(nodes * sizeof *guide->nodes);
    guide_find_light(guide);
    guide_find_entrances(guide);
    if (guide->useful)
        parallel_run(options->threads, nodes, NULL, node_aim, guide);
    return guide;
}

void guide_look(const struct guide *guide, vec3 point, vec3 normal, bool lit,
                struct guide_aim *aim)
{
    uint32_t node = skeleton_find(guide->skeleton, point, normal, point).node;
    aim->count = 0;
    aim->light = 0;
    if (node == GRAPH_NONE)
        return;
    const struct node_targets *targets = &guide->nodes[node];
    aim->light = targets->light;
    for (int i = 0; !lit && i < targets->count; i++) {
        const struct target *target = &targets->at[i];
        vec3 axis = vec3_normalise(vec3_sub(target->place, point));
        if (vec3_dot(axis, normal) > 0)
            aim->at[aim->count++] =
                (struct guide_lobe){ axis, lobe_power, target->chance };
    }
}
