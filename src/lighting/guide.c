/* Skeleton-guided sampling: see guide.h. A node looks around by rays; what they
 * meet is sorted into cells of directions, and those that bring most light are
 * its targets: where their light comes from, on average, and how far that is
 * spread. From a surface a target is a lobe cos^s around the direction to it,
 * as wide as it is seen from there, so that a target that is near a surface and
 * far from its node is looked for in the right place (Ruppert, Herholz and
 * Lensch, "Robust fitting of parallax-aware mixtures for path guiding",
 * 2020); the normalisation is (s + 1)/(2 pi). */
#include "lighting/guide.h"

#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"
#include "base/side.h"
#include "base/warp.h"
#include "lighting/void_skeleton.h"
#include "skeleton/heuristic.h"

enum {
    LOOKS = 128, /* rays of a node */
    EDGE = 2,    /* cells along a side of the cube of directions */
    CELLS = SIDES * EDGE * EDGE,
    /* A guide may be rough: the skeleton's voxels along the longest side, if
     * the scene names no number, and the rays between its walls. */
    VOXELS = 64,
    WALL_RAYS = 50000
};

/* How often lobes are used where targets bring all the light, and the least and
 * the largest s. */
static const double chance_most = 0.75, power_least = 1, power_most = 40;

/* Where light differs by less, but for a tenth of the nodes at either end, all
 * paths are worth about the same. */
static const double even = 8;

/* The key of nodes' rays, beside the seed. */
static const uint64_t look_key = 0x6775696465;

struct target {
    vec3 place;      /* the mean of where its light comes from */
    double spread;   /* the mean square of the distance from there */
    double strength; /* its share of the node's light */
};

/* What a node knows. */
struct node_targets {
    int count;
    struct target at[GUIDE_TARGETS];
    double rest;  /* the share of the light that is no target's */
    double light; /* indirect irradiance, the largest of the colours */
};

struct guide {
    struct void_skeleton made;
    const struct skeleton *skeleton; /* of `made` */
    struct node_targets *nodes;
    bool useful; /* else nodes have no targets */
};

void guide_free(struct guide *guide)
{
    if (!guide)
        return;
    memory_free(guide->nodes);
    void_skeleton_free(&guide->made);
    memory_free(guide);
}

/* Sums of what the rays of a cell meet. */
struct look_cell {
    double light;
    vec3 place;    /* times light */
    double square; /* of its distance from the node, times light */
};

static int cell_along(double x, double size)
{
    int at = (int)((x / size + 1) / 2 * EDGE);
    return at < 0 ? 0 : at >= EDGE ? EDGE - 1 : at;
}

/* The cell of the cube of directions. */
static int cell_of(vec3 d)
{
    int side = side_of(d), axis = side / 2;
    double size = fabs(vec3_component(d, axis));
    int u = cell_along(vec3_component(d, (axis + 1) % 3), size);
    int v = cell_along(vec3_component(d, (axis + 2) % 3), size);
    return (side * EDGE + u) * EDGE + v;
}

/* Places are told from the node. What is out of the grid is as far as that is
 * large. */
static void node_look(const struct guide *guide, uint32_t node,
                      struct look_cell cells[CELLS])
{
    const struct skeleton *skeleton = guide->skeleton;
    const struct voxels *v = skeleton->voxels;
    double far = v->edge * (v->size[0] + v->size[1] + v->size[2]);
    const uint64_t key = random_key(skeleton->seed ^ look_key, node);
    for (uint32_t i = 0; i < LOOKS; i++) {
        struct draws draws = { key, i };
        double u[2], distance;
        draw_pair(&draws, 0, u);
        struct ray ray = { skeleton->graph->nodes[node].position,
                           warp_sphere(u) };
        double light = rgb_peak(skeleton->heuristic->seen(
            skeleton, &ray, random_key(key, i), &distance));
        if (!(light > 0) || !isfinite(light))
            continue;
        struct look_cell *into = &cells[cell_of(ray.direction)];
        distance = fmin(distance, far);
        into->light += light;
        into->place = vec3_along(into->place, ray.direction, light * distance);
        into->square += light * distance * distance;
    }
}

/* The strongest cells are the targets; what was taken is 0 then. */
static void node_choose(const struct guide *guide, uint32_t node,
                        struct look_cell cells[CELLS], double sum)
{
    struct node_targets *targets = &guide->nodes[node];
    vec3 from = guide->skeleton->graph->nodes[node].position;
    targets->rest = 1;
    while (targets->count < GUIDE_TARGETS) {
        struct look_cell *best = cells;
        for (int i = 1; i < CELLS; i++)
            if (cells[i].light > best->light)
                best = &cells[i];
        if (!(best->light > 0))
            return;
        vec3 place = vec3_scale(best->place, 1 / best->light);
        double spread = best->square / best->light - vec3_dot(place, place);
        targets->at[targets->count++] =
            (struct target){ vec3_add(from, place), fmax(spread, 0),
                             best->light / sum };
        targets->rest -= best->light / sum;
        best->light = 0;
    }
}

static void node_aim(void *context, size_t item, unsigned thread)
{
    struct guide *guide = context;
    struct look_cell cells[CELLS] = { { 0 } };
    double sum = 0;
    (void)thread;
    node_look(guide, (uint32_t)item, cells);
    for (int i = 0; i < CELLS; i++)
        sum += cells[i].light;
    if (sum > 0 && isfinite(sum))
        node_choose(guide, (uint32_t)item, cells, sum);
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
    struct guide *guide = memory_new(sizeof *guide);
    struct void_skeleton_wish wish = { .heuristic = "network",
                                       .resolution = VOXELS,
                                       .rays = WALL_RAYS };
    if (!void_skeleton_make(&guide->made, world, scene, wish, options, diag)) {
        guide_free(guide);
        return NULL;
    }
    guide->skeleton = guide->made.skeleton;
    size_t nodes = guide->skeleton->graph->count;
    guide->nodes = memory_new(nodes * sizeof *guide->nodes);
    guide_find_light(guide);
    if (guide->useful)
        parallel_run(options->threads, nodes, NULL, node_aim, guide);
    return guide;
}

/* A target seen from a point with a normal; false: it is behind. */
static bool target_lobe(const struct target *target, vec3 point, vec3 normal,
                        struct guide_lobe *lobe)
{
    vec3 to = vec3_sub(target->place, point);
    double square = vec3_dot(to, to);
    lobe->axis = vec3_normalise(to);
    double cosine = vec3_dot(lobe->axis, normal);
    /* Of a lobe cos^s the mean square of the sine is 2/(s + 3). */
    double power = 2 * square / (target->spread + 1e-9 * square) - 3;
    lobe->power = fmin(fmax(power, power_least), power_most);
    lobe->chance = target->strength * cosine;
    return cosine > 0;
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
    double sum = targets->rest / 4; /* the mean cosine, 0 if behind, of light
                                     * that comes from all around */
    aim->light = targets->light;
    for (int i = 0; !lit && i < targets->count; i++) {
        struct guide_lobe *lobe = &aim->at[aim->count];
        if (!target_lobe(&targets->at[i], point, normal, lobe))
            continue;
        sum += lobe->chance;
        aim->count++;
    }
    for (int i = 0; i < aim->count; i++)
        aim->at[i].chance *= chance_most / sum;
}
