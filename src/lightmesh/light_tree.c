/* Clusters of lamps and cuts through them: see light_tree.h. */
#include "lightmesh/light_tree.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/tuning.h"

/* A cluster: lamps first..first+count-1 of the sorted ones. Nodes are in
 * depth-first order: the first child is the next, `second` the other. */
struct light_node {
    vec3 low, high;
    double intensity;
    const struct lamp *model; /* all its lamps fade like this one; or NULL */
    size_t first, count, second;
};

struct light_place {
    vec3 place;
    double intensity;
    const struct lamp *lamp;
};

struct light_tree {
    struct light_place *places;
    double *before; /* summed intensity of those before; one more than lamps */
    struct light_node *nodes;
    size_t count, node_count;
};

static double lamp_intensity(const struct lamp *lamp)
{
    rgb c = lamp->light->colour;
    return (fabs(c.r) + fabs(c.g) + fabs(c.b)) / 3;
}

static int place_order(const struct light_place *a, const struct light_place *b,
                       int axis)
{
    double x = vec3_component(a->place, axis);
    double y = vec3_component(b->place, axis);
    if (x != y)
        return x < y ? -1 : 1;
    return a->lamp->number < b->lamp->number ? -1 : 1;
}

static void place_swap(struct light_place *a, struct light_place *b)
{
    struct light_place keep = *a;
    *a = *b;
    *b = keep;
}

/* Puts the k smallest first: selection by halves around a pivot (Hoare). */
static void places_select(struct light_place *places, size_t count, size_t k,
                          int axis)
{
    size_t low = 0, high = count - 1;
    while (low < high) {
        size_t kept = low;
        place_swap(&places[low + (high - low) / 2], &places[high]);
        for (size_t i = low; i < high; i++)
            if (place_order(&places[i], &places[high], axis) < 0)
                place_swap(&places[i], &places[kept++]);
        place_swap(&places[kept], &places[high]);
        if (kept == k)
            return;
        if (kept < k)
            low = kept + 1;
        else
            high = kept - 1;
    }
}

static void node_measure(const struct light_tree *tree, struct light_node *node)
{
    const struct light_place *places = &tree->places[node->first];
    const struct lamp *model = places->lamp;
    node->low = node->high = places->place;
    bool alike = model->fades && !lamp_is_parallel(model);
    for (size_t i = 0; i < node->count; i++) {
        const struct lamp *lamp = places[i].lamp;
        node->low = vec3_min(node->low, places[i].place);
        node->high = vec3_max(node->high, places[i].place);
        node->intensity += places[i].intensity;
        if (!lamp->fades || lamp_is_parallel(lamp) ||
            lamp->light->fade_distance != model->light->fade_distance ||
            lamp->light->fade_power != model->light->fade_power)
            alike = false;
    }
    node->model = alike ? model : NULL;
}

static void tree_build(struct light_tree *tree, size_t first, size_t count)
{
    struct light_node *node = &tree->nodes[tree->node_count++];
    *node = (struct light_node){ .first = first, .count = count };
    node_measure(tree, node);
    if (count == 1)
        return;
    vec3 size = vec3_sub(node->high, node->low);
    int axis = size.x >= size.y ? 0 : 1;
    axis = size.z > vec3_component(size, axis) ? 2 : axis;
    places_select(&tree->places[first], count, count / 2, axis);
    tree_build(tree, first, count / 2);
    node->second = tree->node_count;
    tree_build(tree, first + count / 2, count - count / 2);
}

struct light_tree *light_tree_new(const struct lamps *lamps, vec3 centre,
                                  double size)
{
    struct light_tree *tree = memory_new(sizeof *tree);
    size_t n = lamps->count;
    tree->places = memory_new((n + 1) * sizeof *tree->places);
    tree->before = memory_new((n + 1) * sizeof *tree->before);
    tree->nodes = memory_new((2 * n + 1) * sizeof *tree->nodes);
    for (size_t i = 0; i < n; i++) {
        const struct lamp *lamp = &lamps->items[i];
        vec3 place = lamp->light->location;
        double intensity = lamp_intensity(lamp);
        if (lamp_is_parallel(lamp))
            place = vec3_along(centre, lamp->axis, -1e4 * size);
        if (intensity > 0)
            tree->places[tree->count++] =
                (struct light_place){ place, intensity, lamp };
    }
    if (tree->count)
        tree_build(tree, 0, tree->count);
    for (size_t i = 0; i < tree->count; i++)
        tree->before[i + 1] = tree->before[i] + tree->places[i].intensity;
    return tree;
}

void light_tree_free(struct light_tree *tree)
{
    if (!tree)
        return;
    memory_free(tree->places);
    memory_free(tree->before);
    memory_free(tree->nodes);
    memory_free(tree);
}

size_t light_tree_count(const struct light_tree *tree)
{
    return tree->count;
}

const struct lamp *light_tree_lamp(const struct light_tree *tree, size_t i)
{
    return tree->places[i].lamp;
}

/* A cut under way: nodes with how much splitting them would help. */
struct light_cut {
    int count;
    struct {
        double spread;
        size_t node;
    } at[PICKS_MAX];
};

/* How wrong one lamp may be for the whole cluster: its light, times the angle
 * it is seen in. */
static double node_spread(const struct light_node *node, vec3 point)
{
    if (node->count == 1)
        return 0;
    vec3 nearest = vec3_max(node->low, vec3_min(node->high, point));
    double gap = vec3_length(vec3_sub(nearest, point));
    double size = vec3_length(vec3_sub(node->high, node->low));
    double light = node->intensity;
    if (node->model)
        light *= lamp_fading(node->model, gap);
    return light * size / (gap + cut_near * size + 1e-30) + light * cut_even;
}

/* A heap: the parent of i is (i - 1) / 2, and spreads more. */
static void cut_sift_up(struct light_cut *cut, int i)
{
    for (; i > 0; i = (i - 1) / 2) {
        int parent = (i - 1) / 2;
        if (cut->at[parent].spread >= cut->at[i].spread)
            break;
        double spread = cut->at[i].spread;
        size_t node = cut->at[i].node;
        cut->at[i] = cut->at[parent];
        cut->at[parent].spread = spread;
        cut->at[parent].node = node;
    }
}

static void cut_sift_down(struct light_cut *cut)
{
    for (int i = 0;;) {
        int child = 2 * i + 1;
        if (child + 1 < cut->count &&
            cut->at[child + 1].spread > cut->at[child].spread)
            child++;
        if (child >= cut->count || cut->at[child].spread <= cut->at[i].spread)
            break;
        double spread = cut->at[i].spread;
        size_t node = cut->at[i].node;
        cut->at[i] = cut->at[child];
        cut->at[child].spread = spread;
        cut->at[child].node = node;
        i = child;
    }
}

/* The cluster that spreads most gives way to its halves. */
static void cut_split(const struct light_tree *tree, struct light_cut *cut,
                      vec3 point)
{
    size_t node = cut->at[0].node, first = node + 1;
    size_t second = tree->nodes[node].second;
    cut->at[0].node = first;
    cut->at[0].spread = node_spread(&tree->nodes[first], point);
    cut_sift_down(cut);
    cut->at[cut->count].node = second;
    cut->at[cut->count].spread = node_spread(&tree->nodes[second], point);
    cut_sift_up(cut, cut->count++);
}

/* The lamp of a cluster at share u of its intensity. */
static struct light_pick node_pick(const struct light_tree *tree,
                                   const struct light_node *node, double u)
{
    size_t low = node->first, high = node->first + node->count - 1;
    double aim =
        tree->before[low] + u * (tree->before[high + 1] - tree->before[low]);
    while (low < high) {
        size_t middle = low + (high - low + 1) / 2;
        if (tree->before[middle] <= aim)
            low = middle;
        else
            high = middle - 1;
    }
    const struct light_place *place = &tree->places[low];
    return (struct light_pick){ place->lamp,
                                node->intensity / place->intensity };
}

int light_tree_pick(const struct light_tree *tree, vec3 point, double dither,
                    int budget, struct light_pick picks[])
{
    struct light_cut cut;
    if (tree->count == 0)
        return 0;
    cut.count = 1;
    cut.at[0].node = 0;
    cut.at[0].spread = node_spread(&tree->nodes[0], point);
    while (cut.count < budget && cut.at[0].spread > 0)
        cut_split(tree, &cut, point);
    for (int i = 0; i < cut.count; i++) {
        size_t node = cut.at[i].node;
        double u = dither + random_unit(node);
        picks[i] = node_pick(tree, &tree->nodes[node], u - floor(u));
    }
    return cut.count;
}
