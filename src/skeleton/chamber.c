/* Chambers: see chamber.h. A watershed of the nodes' radii: nodes from the
 * widest to the narrowest flood basins; where two basins meet at a node that
 * is narrower than `constriction` times the smaller one's widest, there is a
 * door between them, else they are one. */
#include "skeleton/chamber.h"

#include <stdlib.h>

#include "base/memory.h"

static const double constriction = 0.75;

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

struct chambers *chambers_new(struct arena *arena, const struct graph *graph)
{
    struct chambers *chambers = ARENA_NEW(arena, struct chambers);
    uint32_t *basin = basins_new(graph);
    chambers->of_node = ARENA_ARRAY(arena, uint32_t, graph->count);
    chambers->count = graph_label(graph, basin, NULL, chambers->of_node);
    memory_free(basin);
    return chambers;
}
