/* Chambers: see chamber.h. A watershed of the nodes' radii: nodes from the
 * widest to the narrowest flood basins; where two basins meet at a node that
 * is narrower than `constriction` times the smaller one's widest, there is a
 * door between them, else they are one. Then each basin is cut into rings
 * around its widest node by distance along the skeleton. */
#include "skeleton/chamber.h"

#include <stdlib.h>

#include "base/memory.h"
#include "skeleton/paths.h"

static const double constriction = 0.75;
/* Half a ring, in radii of the widest node; of 0.8 to 1.25 the one that was
 * closest to path in examples/light. */
static const double ring_width = 1.1;

struct ranked {
    double radius;
    uint32_t node;
};

static int ranked_compare(const void *a, const void *b)
{
    const struct ranked *p = a, *q = b;
    if (p->radius != q->radius)
        return p->radius > q->radius ? -1 : 1;
    return p->node < q->node ? -1 : p->node > q->node;
}

/* Basins are trees of nodes: up leads to the node that was widest. */
static uint32_t basin_of(uint32_t *up, uint32_t node)
{
    while (up[node] != node) {
        up[node] = up[up[node]];
        node = up[node];
    }
    return node;
}

/* Joins the narrower of two basins to the wider. */
static void basin_join(const struct graph *graph, uint32_t *up, uint32_t a,
                       uint32_t b)
{
    const struct graph_node *nodes = graph->nodes;
    struct ranked p = { nodes[a].radius, a }, q = { nodes[b].radius, b };
    if (ranked_compare(&p, &q) < 0)
        up[b] = a;
    else
        up[a] = b;
}

static double smaller_peak(const struct graph *graph, uint32_t a, uint32_t b)
{
    return fmin(graph->nodes[a].radius, graph->nodes[b].radius);
}

/* Floods one node: it joins the widest basin it touches; others too if there
 * is no door between. */
static void basin_flood(const struct graph *graph, uint32_t *up, uint32_t node)
{
    uint32_t best = GRAPH_NONE;
    double radius = graph->nodes[node].radius;
    for (uint32_t k = graph->first[node]; k < graph->first[node + 1]; k++) {
        uint32_t next = graph->neighbours[k];
        if (up[next] == GRAPH_NONE)
            continue;
        next = basin_of(up, next);
        if (best == GRAPH_NONE ||
            graph->nodes[next].radius > graph->nodes[best].radius)
            best = next;
    }
    up[node] = best == GRAPH_NONE ? node : best;
    for (uint32_t k = graph->first[node]; k < graph->first[node + 1]; k++) {
        uint32_t next = graph->neighbours[k], own = basin_of(up, node);
        if (up[next] == GRAPH_NONE)
            continue;
        next = basin_of(up, next);
        if (next != own &&
            radius >= constriction * smaller_peak(graph, next, own))
            basin_join(graph, up, next, own);
    }
}

/* For each node the widest of its basin. */
static uint32_t *basins_new(const struct graph *graph)
{
    uint32_t *up = memory_new(graph->count * sizeof *up);
    struct ranked *ranked = memory_new(graph->count * sizeof *ranked);
    for (size_t i = 0; i < graph->count; i++) {
        up[i] = GRAPH_NONE;
        ranked[i] = (struct ranked){ graph->nodes[i].radius, (uint32_t)i };
    }
    if (graph->count > 0)
        qsort(ranked, graph->count, sizeof *ranked, ranked_compare);
    for (size_t i = 0; i < graph->count; i++)
        basin_flood(graph, up, ranked[i].node);
    for (size_t i = 0; i < graph->count; i++)
        up[i] = basin_of(up, (uint32_t)i);
    memory_free(ranked);
    return up;
}

/* Which ring around its basin's widest node each node is in. */
static uint32_t *rings_new(const struct graph *graph, const uint32_t *basin)
{
    struct arena *arena = arena_new(0);
    uint32_t *rings = memory_new(graph->count * sizeof *rings);
    uint32_t *peaks = ARENA_ARRAY(arena, uint32_t, graph->count);
    struct paths_from from = { .sources = peaks, .group = basin };
    for (size_t i = 0; i < graph->count; i++)
        if (basin[i] == i)
            peaks[from.count++] = (uint32_t)i;
    const struct paths *paths = paths_new(arena, graph, &from);
    for (size_t i = 0; i < graph->count; i++) {
        double width = ring_width * graph->nodes[basin[i]].radius;
        double far = ((double)paths->distance[i] - width) / (2 * width);
        rings[i] = far < 0 ? 0 : 1 + (uint32_t)far;
    }
    arena_free(arena);
    return rings;
}

/* Connected nodes of one basin and one ring are a chamber. */
struct chambers *chambers_new(struct arena *arena, const struct graph *graph)
{
    struct chambers *chambers = ARENA_NEW(arena, struct chambers);
    uint32_t *basin = basins_new(graph), *ring = rings_new(graph, basin);
    chambers->of_node = ARENA_ARRAY(arena, uint32_t, graph->count);
    chambers->count = graph_label(graph, basin, ring, chambers->of_node);
    memory_free(ring);
    memory_free(basin);
    return chambers;
}
