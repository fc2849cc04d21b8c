/* The parts of a blob, and boxes over them: which of them are near a point or
 * a ray. */
#ifndef SCENE_BLOB_TREE_H
#define SCENE_BLOB_TREE_H

#include <stdint.h>

#include "scene/blob.h"
#include "scene/slab.h"

/* A part as rays meet it. */
struct blob_body {
    struct blob_part part;
    bool round; /* a ball, whose space is moved and sized only: */
    vec3 centre;
    double inverse; /* of its radius, squared */
    size_t number;  /* of the part */
};

/* Nodes come before those below them; `next` is the first that is not. */
struct blob_node {
    struct box3 box;
    uint32_t next;
    uint32_t first, count; /* bodies; 0 of an inner node */
};

struct blob_tree {
    struct blob_body *bodies; /* those of a node together */
    struct blob_node *nodes;
    uint32_t body_count, node_count;
};

/* In `arena`, of at least one part. */
const struct blob_tree *
blob_tree_new(struct arena *arena, const struct blob_part *parts, size_t count);

/* Around all that has this part's density; infinite if it is flattened. */
struct box3 blob_part_box(const struct blob_part *part);

/* The next leaf from node `at` on whose box the ray meets between tmin and
 * tmax; NULL: there is none. Ask again with its `next`. */
static inline const struct blob_node *
blob_tree_leaf(const struct blob_tree *tree, uint32_t at,
               const struct slabs *slabs, double tmin, double tmax)
{
    while (at < tree->node_count) {
        const struct blob_node *node = &tree->nodes[at];
        if (!slabs_hit(slabs, &node->box, tmin, tmax))
            at = node->next;
        else if (node->count)
            return node;
        else
            at++;
    }
    return NULL;
}

/* The same of a point. */
static inline const struct blob_node *
blob_tree_leaf_at(const struct blob_tree *tree, uint32_t at, vec3 point)
{
    while (at < tree->node_count) {
        const struct blob_node *node = &tree->nodes[at];
        if (!box3_contains(node->box, point))
            at = node->next;
        else if (node->count)
            return node;
        else
            at++;
    }
    return NULL;
}

#endif
