/* Building boxes over a blob's parts: see blob_tree.h. */
#include "scene/blob_tree.h"

#include <stdlib.h>

enum { BODIES_A_LEAF = 2 };

/* A body on its way into the tree. */
struct seed {
    struct box3 box;
    double key;
    struct blob_body body;
};

struct box3 blob_part_box(const struct blob_part *part)
{
    struct box3 box = { { -1, -1, -1 }, { 1, 1, 1 + part->length } };
    affine outward;
    if (!affine_inverse(part->inward, &outward))
        return box3_infinite();
    return affine_box(&outward, box);
}

/* Whether a ball stays one: its matrix is that of a change of size. */
static bool part_is_round(const struct blob_part *part)
{
    const double(*m)[4] = part->inward.m;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (i == j ? m[i][j] != m[0][0] : m[i][j] != 0)
                return false;
    return part->length == 0;
}

static struct blob_body body_of(const struct blob_part *part)
{
    struct blob_body body = { .part = *part };
    const double(*m)[4] = part->inward.m;
    double scale = m[0][0];
    body.round = part_is_round(part);
    body.inverse = scale * scale;
    if (body.round)
        body.centre =
            vec3_make(-m[0][3] / scale, -m[1][3] / scale, -m[2][3] / scale);
    return body;
}

static int seed_order(const void *a, const void *b)
{
    const struct seed *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

static void seeds_sort(struct seed *seeds, size_t count)
{
    struct box3 all = box3_empty();
    for (size_t i = 0; i < count; i++)
        all = box3_add(all, vec3_mix(seeds[i].box.low, seeds[i].box.high, 0.5));
    vec3 size = vec3_sub(all.high, all.low);
    int axis = size.x >= size.y && size.x >= size.z ? 0
               : size.y >= size.z                   ? 1
                                                    : 2;
    for (size_t i = 0; i < count; i++)
        seeds[i].key = vec3_component(seeds[i].box.low, axis) +
                       vec3_component(seeds[i].box.high, axis);
    qsort(seeds, count, sizeof *seeds, seed_order);
}

static struct box3 build(struct blob_tree *tree, struct seed *seeds,
                         size_t count)
{
    struct blob_node *node = &tree->nodes[tree->node_count++];
    struct box3 box = box3_empty();
    *node = (struct blob_node){ .first = tree->body_count };
    if (count <= BODIES_A_LEAF) {
        node->count = (uint32_t)count;
        for (size_t i = 0; i < count; i++) {
            box = box3_union(box, seeds[i].box);
            tree->bodies[tree->body_count++] = seeds[i].body;
        }
    } else {
        size_t half = count / 2;
        seeds_sort(seeds, count);
        box = build(tree, seeds, half);
        box = box3_union(box, build(tree, seeds + half, count - half));
    }
    node->box = box;
    node->next = tree->node_count;
    return box;
}

const struct blob_tree *
blob_tree_new(struct arena *arena, const struct blob_part *parts, size_t count)
{
    struct blob_tree *tree = ARENA_NEW(arena, struct blob_tree);
    struct arena *scratch = arena_new(0);
    struct seed *seeds = ARENA_ARRAY(scratch, struct seed, count);
    for (size_t i = 0; i < count; i++) {
        seeds[i] = (struct seed){ .box = blob_part_box(&parts[i]),
                                  .body = body_of(&parts[i]) };
        seeds[i].body.number = i;
    }
    tree->bodies = ARENA_ARRAY(arena, struct blob_body, count);
    tree->nodes = ARENA_ARRAY(arena, struct blob_node, 2 * count);
    build(tree, seeds, count);
    arena_free(scratch);
    return tree;
}
