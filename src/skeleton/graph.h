/* The skeleton as a graph: a node for every point of the collapsed complex, an
 * arc for every edge. Nodes know how wide the void is around them. */
#ifndef SKELETON_GRAPH_H
#define SKELETON_GRAPH_H

#include "base/arena.h"
#include "skeleton/complex.h"

/* No node: of voxels of matter, and of what no node can be reached from. */
#define GRAPH_NONE UINT32_MAX

struct graph_node {
    vec3 position; /* world; within the void, or on a face of it */
    double radius; /* of the ball of void around it, world units, > 0 */
};

struct graph {
    size_t count;
    struct graph_node *nodes;
    /* The neighbours of node i: neighbours[first[i]] up to first[i + 1]. */
    uint32_t *first, *neighbours;
    uint32_t *part; /* which connected part each node belongs to */
    size_t parts;
};

/* From a collapsed complex; `squared` is distance_squared of the voxels. The
 * staircase is smoothed: positions become means of their neighbours', as long
 * as they stay in the void. All of it in the arena. */
struct graph *graph_new(struct arena *arena, const struct complex *complex,
                        const struct voxels *voxels, const int32_t *squared);

/* For every voxel the node that is closest on ways through void voxels (of six
 * neighbours): out[voxels_count]. Never reaches through a wall. */
void graph_nearest(const struct complex *complex, const struct voxels *voxels,
                   uint32_t *out);

/* Numbers the connected pieces of nodes that agree in `group` and `also` (NULL:
 * all do) into out[count]; returns how many there are. */
size_t graph_label(const struct graph *graph, const uint32_t *group,
                   const uint32_t *also, uint32_t *out);

/* How long the arc between two nodes is, world units. */
double graph_length(const struct graph *graph, uint32_t a, uint32_t b);

#endif
