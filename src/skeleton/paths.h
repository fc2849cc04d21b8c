/* Shortest ways along the skeleton, from everywhere to where light enters. */
#ifndef SKELETON_PATHS_H
#define SKELETON_PATHS_H

#include "skeleton/graph.h"

struct paths {
    uint32_t *parent; /* one step closer; GRAPH_NONE: a source, or no way */
    float *distance;  /* along the arcs, world units; INFINITY: no way */
    float *narrow;    /* the narrowest ball on the way, over its source's */
};

/* Where ways begin, and which arcs they may take. */
struct paths_from {
    const uint32_t *sources;
    const double *start; /* the distance each begins with; NULL: 0 */
    size_t count;
    const uint32_t *group; /* of each node: ways stay in theirs; or NULL */
};

/* Dijkstra's algorithm from several nodes at once, in the arena. */
struct paths *paths_new(struct arena *arena, const struct graph *graph,
                        const struct paths_from *from);

#endif
