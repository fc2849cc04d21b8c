/* How the tree of shafts is built: see shaft_tree.h. */
#include "world/shaft_tree.h"

#include <stdlib.h>

#include "scene/mesh.h"

/* So many items are parted by trying all places, unless there are very many,
 * for that takes its time; of too many there is no tree. */
enum { SWEEP_MOST = 128, SWEEP_WORTH = 4000, TREE_MOST = 20000 };

static uint32_t spread_bits(uint32_t x)
{
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

/* Of the place of a value between two others, ten bits apart from each other.
 */
static uint32_t place_bits(double low, double high, double value)
{
    double place = high > low ? (value - low) / (high - low) : 0;
    return spread_bits((uint32_t)(fmin(fmax(place, 0), 1) * 1023));
}

static vec3 item_middle(const struct shaft_item *item)
{
    return vec3_scale(vec3_add(item->box.low, item->box.high), 0.5);
}

static int item_order(const void *a, const void *b)
{
    const struct shaft_item *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

static void items_sort(struct shaft_item *items, size_t count)
{
    qsort(items, count, sizeof *items, item_order);
}

/* Along a space-filling curve (Lauterbach et al. 2009). */
static void items_sort_along_curve(struct shaft_tree *tree)
{
    struct box3 all = box3_empty();
    for (size_t i = 0; i < tree->item_count; i++)
        all = box3_union(all, tree->items[i].box);
    for (size_t i = 0; i < tree->item_count; i++) {
        vec3 middle = item_middle(&tree->items[i]);
        tree->items[i].key = place_bits(all.low.x, all.high.x, middle.x) |
                             place_bits(all.low.y, all.high.y, middle.y) << 1 |
                             place_bits(all.low.z, all.high.z, middle.z) << 2;
    }
    items_sort(tree->items, tree->item_count);
}

static void items_sort_along_axis(struct shaft_item *items, size_t count,
                                  int axis)
{
    for (size_t i = 0; i < count; i++)
        items[i].key = vec3_component(item_middle(&items[i]), axis);
    items_sort(items, count);
}

/* Sorts them along the axis, and returns how many of the first make the best
 * first half: boxes are met the more often the larger they are (surface area
 * heuristic). *cost is what that is worth, the less the better. */
static size_t items_halve(struct shaft_item *items, size_t count, int axis,
                          double *cost)
{
    double before[SWEEP_MOST];
    struct box3 box = box3_empty();
    size_t best = count / 2;
    items_sort_along_axis(items, count, axis);
    for (size_t i = 0; i < count; i++) {
        before[i] = box3_half_area(box) * (double)i;
        box = box3_union(box, items[i].box);
    }
    *cost = HUGE_VAL;
    box = box3_empty();
    for (size_t i = count - 1; i > 0; i--) {
        box = box3_union(box, items[i].box);
        double sum = before[i] + box3_half_area(box) * (double)(count - i);
        if (sum < *cost) {
            *cost = sum;
            best = i;
        }
    }
    return best;
}

static size_t items_split(const struct shaft_tree *tree,
                          struct shaft_item *items, size_t count)
{
    double cost, least = HUGE_VAL;
    int best = 0;
    if (count > SWEEP_MOST || tree->item_count > SWEEP_WORTH)
        return count / 2;
    for (int axis = 0; axis < 3; axis++) {
        items_halve(items, count, axis, &cost);
        best = cost < least ? axis : best;
        least = fmin(cost, least);
    }
    return items_halve(items, count, best, &cost);
}

static struct box3 build_nodes(struct shaft_tree *tree, size_t first,
                               size_t count)
{
    struct shaft_node *node = &tree->nodes[tree->node_count++];
    if (count == 1) {
        node->leaf = true;
        node->solid = tree->items[first].solid;
        node->box = tree->items[first].box;
    } else {
        size_t half = items_split(tree, &tree->items[first], count);
        struct box3 a = build_nodes(tree, first, half);
        struct box3 b = build_nodes(tree, first + half, count - half);
        node->box = box3_union(a, b);
    }
    node->next = tree->node_count;
    return node->box;
}

static void tree_add(struct shaft_tree *tree, struct box3 box,
                     const struct solid *solid)
{
    struct shaft_item item = { .box = box, .solid = solid };
    if (box3_is_empty(box) ||
        (solid && solid->leaf && solid->leaf->look->no_shadow))
        return;
    if (box3_is_finite(box))
        tree->items[tree->item_count++] = item;
    else
        tree->endless[tree->endless_count++] = item;
}

static void tree_add_solids(struct shaft_tree *tree,
                            const struct solid_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        tree_add(tree, list->items[i]->surface, list->items[i]);
}

struct shaft_tree *shaft_tree_new(struct flat *flat,
                                  const struct solid_list *bounded)
{
    struct arena *arena = flat->arena;
    size_t room = flat->solids.count + bounded->count + flat->meshes.count;
    if (room > TREE_MOST)
        return NULL;
    struct shaft_tree *tree = ARENA_NEW(arena, struct shaft_tree);
    tree->items = ARENA_ARRAY(arena, struct shaft_item, room);
    tree->endless = ARENA_ARRAY(arena, struct shaft_item, room);
    tree->nodes = ARENA_ARRAY(arena, struct shaft_node, 2 * room);
    tree_add_solids(tree, &flat->solids);
    tree_add_solids(tree, bounded);
    for (size_t i = 0; i < flat->meshes.count; i++) {
        const struct leaf *leaf = flat->meshes.items[i];
        if (!leaf->look->no_shadow)
            tree_add(tree,
                     solid_padded(affine_box(leaf->pose->outward,
                                             leaf->object->mesh->bounds)),
                     NULL);
    }
    items_sort_along_curve(tree);
    if (tree->item_count > 0)
        build_nodes(tree, 0, tree->item_count);
    return tree;
}
