/* The parts of a blob, and boxes over them: which of them are near a point or
 * a ray. */
#ifndef SCENE_BLOB_TREE_H
#define SCENE_BLOB_TREE_H

#include <stdint.h>

#include "scene/blob.h"
#include "scene/slab.h"

/* Nodes on the longest way down, at most: each has half of those above it. */
enum { BLOB_DEPTH = 32 };

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

/* A ray on its way through the tree. */
struct blob_walk {
    const struct blob_tree *tree;
    struct slabs slabs;
    double tmin, tmax;
    int count; /* nodes whose boxes it meets too, the next last */
    uint32_t wait[BLOB_DEPTH];
};

static inline struct blob_walk blob_walk_of(const struct blob_tree *tree,
                                            const struct ray *ray, double tmin,
                                            double tmax)
{
    struct blob_walk walk; /* no more of it than is needed */
    walk.tree = tree;
    walk.slabs = slabs_of(ray);
    walk.tmin = tmin;
    walk.tmax = tmax;
    walk.wait[0] = 0;
    walk.count = slabs_hit(&walk.slabs, &tree->nodes[0].box, tmin, tmax);
    return walk;
}

/* The next leaf whose box the ray meets; NULL: there is none. */
static inline const struct blob_node *blob_walk_on(struct blob_walk *walk)
{
    const struct blob_node *nodes = walk->tree->nodes;
    while (walk->count > 0) {
        uint32_t at = walk->wait[--walk->count];
        while (!nodes[at].count) {
            uint32_t near = at + 1, far = nodes[near].next;
            int met = slabs_hit_two(&walk->slabs, &nodes[near].box,
                                    &nodes[far].box, walk->tmin, walk->tmax);
            if (!met)
                break;
            at = met & 1 ? near : far;
            walk->wait[walk->count] = far;
            walk->count += met == 3;
        }
        if (nodes[at].count)
            return &nodes[at];
    }
    return NULL;
}

/* The next leaf from node `at` on whose box has the point; NULL: there is none.
 * Ask again with its `next`. */
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
