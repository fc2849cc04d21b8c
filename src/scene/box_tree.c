/* A tree of boxes: see box_tree.h. Halved at the median of the longest side
 * over the middles; nodes in an array, a node's first child after it. */
#include "scene/box_tree.h"

#include "scene/slab.h"

#include <stdint.h>
#include <stdlib.h>

enum {
    TREE_LEAF = 2,   /* items */
    TREE_DEPTH = 64, /* halving 2^64 items */
};

struct box_node {
    struct box3 box;
    uint32_t first; /* of a leaf: into items; else the second child */
    uint16_t count; /* of a leaf; 0: a node */
    uint16_t axis;
};

struct box_tree {
    struct box_node *nodes;
    uint32_t *items;
    size_t node_count;
};

struct box_builder {
    struct box_tree *tree;
    struct middle {
        double at[3];
        uint32_t item;
    } * middles;
    const struct box3 *boxes;
};

static double axis_of(vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/* The middles from..to so that none before `middle` is beyond it. */
static void middles_split(struct middle *m, size_t from, size_t to,
                          size_t middle, int axis)
{
    while (to - from > 1) {
        double pivot = m[from + (to - from - 1) / 2].at[axis];
        size_t i = from, j = to - 1;
        for (;;) {
            while (m[i].at[axis] < pivot)
                i++;
            while (m[j].at[axis] > pivot)
                j--;
            if (i >= j)
                break;
            struct middle swap = m[i];
            m[i++] = m[j];
            m[j--] = swap;
        }
        if (middle <= j)
            to = j + 1;
        else
            from = j + 1;
    }
}

static void node_build(struct box_builder *b, size_t from, size_t to)
{
    struct box_tree *tree = b->tree;
    size_t number = tree->node_count++;
    struct box_node *node = &tree->nodes[number];
    struct box3 box = box3_empty(), middles = box3_empty();
    for (size_t i = from; i < to; i++) {
        const double *at = b->middles[i].at;
        box = box3_union(box, b->boxes[b->middles[i].item]);
        middles = box3_add(middles, vec3_make(at[0], at[1], at[2]));
    }
    node->box = box;
    vec3 size = vec3_sub(middles.high, middles.low);
    int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2)
                                : (size.y >= size.z ? 1 : 2);
    if (to - from <= TREE_LEAF) {
        node->first = (uint32_t)from;
        node->count = (uint16_t)(to - from);
        for (size_t i = from; i < to; i++)
            tree->items[i] = b->middles[i].item;
        return;
    }
    size_t middle = from + (to - from) / 2;
    middles_split(b->middles, from, to, middle, axis);
    node->axis = (uint16_t)axis;
    node_build(b, from, middle);
    node->first = (uint32_t)tree->node_count;
    node_build(b, middle, to);
}

const struct box_tree *box_tree_new(struct arena *arena,
                                    const struct box3 *boxes, size_t count)
{
    struct box_tree *tree = ARENA_NEW(arena, struct box_tree);
    struct box_builder b = { tree, ARENA_ARRAY(arena, struct middle, count),
                             boxes };
    tree->nodes = ARENA_ARRAY(arena, struct box_node, 2 * count + 1);
    tree->items = ARENA_ARRAY(arena, uint32_t, count + 1);
    for (size_t i = 0; i < count; i++) {
        vec3 m = vec3_scale(vec3_add(boxes[i].low, boxes[i].high), 0.5);
        b.middles[i] = (struct middle){ { m.x, m.y, m.z }, (uint32_t)i };
    }
    if (count > 0)
        node_build(&b, 0, count);
    return tree;
}

/* Whether the ray is in the slab between low and high within *near..*far. */
static bool slab(double origin, double inverse, double low, double high,
                 double *near, double *far)
{
    double a = (low - origin) * inverse, b = (high - origin) * inverse;
    *near = greater(*near, lesser(a, b));
    *far = lesser(*far, greater(a, b));
    return *near <= *far;
}

static bool node_met(const struct box_node *node, const struct ray *ray,
                     vec3 inverse, double near, double far)
{
    const struct box3 *box = &node->box;
    vec3 o = ray->origin;
    return slab(o.x, inverse.x, box->low.x, box->high.x, &near, &far) &&
           slab(o.y, inverse.y, box->low.y, box->high.y, &near, &far) &&
           slab(o.z, inverse.z, box->low.z, box->high.z, &near, &far);
}

void box_tree_ray(const struct box_tree *tree, const struct ray *ray,
                  double tmin, const double *tmax, box_tree_visit *visit,
                  void *context)
{
    uint32_t stack[TREE_DEPTH + 1];
    vec3 d = ray->direction, inverse = slabs_of(ray).inverse;
    int depth = 0;
    if (tree->node_count > 0)
        stack[depth++] = 0;
    while (depth > 0) {
        uint32_t number = stack[--depth];
        const struct box_node *node = &tree->nodes[number];
        if (!node_met(node, ray, inverse, tmin, *tmax))
            continue;
        for (uint32_t i = 0; i < node->count; i++)
            if (visit(context, tree->items[node->first + i]))
                return;
        if (node->count > 0)
            continue;
        bool back = axis_of(d, node->axis) < 0;
        stack[depth++] = back ? number + 1 : node->first;
        stack[depth++] = back ? node->first : number + 1;
    }
}

static bool boxes_meet(const struct box3 *a, const struct box3 *b)
{
    return a->low.x <= b->high.x && b->low.x <= a->high.x &&
           a->low.y <= b->high.y && b->low.y <= a->high.y &&
           a->low.z <= b->high.z && b->low.z <= a->high.z;
}

void box_tree_box(const struct box_tree *tree, struct box3 box,
                  box_tree_visit *visit, void *context)
{
    uint32_t stack[TREE_DEPTH + 1];
    int depth = 0;
    if (tree->node_count > 0)
        stack[depth++] = 0;
    while (depth > 0) {
        uint32_t number = stack[--depth];
        const struct box_node *node = &tree->nodes[number];
        if (!boxes_meet(&node->box, &box))
            continue;
        for (uint32_t i = 0; i < node->count; i++)
            if (visit(context, tree->items[node->first + i]))
                return;
        if (node->count > 0)
            continue;
        stack[depth++] = node->first;
        stack[depth++] = number + 1;
    }
}
