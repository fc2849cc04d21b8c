/* The tree of boxes that shafts are held against (shaft.h): of all that casts
 * shadows, parted by the surface area heuristic. */
#ifndef WORLD_SHAFT_TREE_H
#define WORLD_SHAFT_TREE_H

#include "world/flatten.h"

/* Something with a box; without a solid it is a mesh. */
struct shaft_item {
    struct box3 box;
    const struct solid *solid;
    double key; /* they are sorted by it */
};

/* In the order in which they are visited: the first child follows. */
struct shaft_node {
    struct box3 box;
    size_t next; /* node to go on with if the box is missed */
    bool leaf;
    const struct solid *solid; /* of a leaf */
};

struct shaft_tree {
    struct shaft_item *items; /* bounded ones, by code */
    struct shaft_node *nodes;
    size_t item_count, node_count;
    struct shaft_item *endless; /* boxes that are not bounded */
    size_t endless_count;
};

/* Of `bounded` and what is in *flat, in whose arena it is. NULL if there is so
 * much that most shafts would be crowded. */
struct shaft_tree *shaft_tree_new(struct flat *flat,
                                  const struct solid_list *bounded);

#endif
