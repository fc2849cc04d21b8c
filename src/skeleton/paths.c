/* Dijkstra with a binary heap. Where two ways are equally long, the node with
 * the lower number goes first: the same ways in every run. */
#include "skeleton/paths.h"

#include "base/memory.h"

struct heap_item {
    double distance;
    uint32_t node;
};

struct heap {
    struct heap_item *items;
    size_t count;
};

static bool item_before(const struct heap_item *a, const struct heap_item *b)
{
    return a->distance < b->distance ||
           (a->distance == b->distance && a->node < b->node);
}

static void heap_push(struct heap *heap, struct heap_item item)
{
    size_t at = heap->count++;
    while (at > 0 && item_before(&item, &heap->items[(at - 1) / 2])) {
        heap->items[at] = heap->items[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    heap->items[at] = item;
}

static struct heap_item heap_pop(struct heap *heap)
{
    struct heap_item first = heap->items[0];
    struct heap_item last = heap->items[--heap->count];
    size_t at = 0, child;
    while ((child = 2 * at + 1) < heap->count) {
        if (child + 1 < heap->count &&
            item_before(&heap->items[child + 1], &heap->items[child]))
            child++;
        if (!item_before(&heap->items[child], &last))
            break;
        heap->items[at] = heap->items[child];
        at = child;
    }
    heap->items[at] = last;
    return first;
}

struct search {
    const struct graph *graph;
    const struct paths_from *from;
    struct paths *paths;
    double *distance; /* more exactly than the result */
    uint32_t *source; /* of each node that was reached */
    struct heap heap;
};

/* The running minimum of the radii, as a share of the source's. */
static double search_narrow(const struct search *search, uint32_t node)
{
    const struct graph_node *nodes = search->graph->nodes;
    uint32_t parent = search->paths->parent[node];
    double share = nodes[node].radius / nodes[search->source[node]].radius;
    return parent == GRAPH_NONE
               ? 1
               : fmin((double)search->paths->narrow[parent], share);
}

static void search_arcs(struct search *search, uint32_t node)
{
    const struct graph *graph = search->graph;
    const uint32_t *group = search->from->group;
    for (uint32_t k = graph->first[node]; k < graph->first[node + 1]; k++) {
        uint32_t next = graph->neighbours[k];
        double far = search->distance[node] + graph_length(graph, node, next);
        if (!(far < search->distance[next]) ||
            (group && group[next] != group[node]))
            continue;
        search->distance[next] = far;
        search->paths->parent[next] = node;
        heap_push(&search->heap, (struct heap_item){ far, next });
    }
}

static void search_run(struct search *search)
{
    struct paths *paths = search->paths;
    while (search->heap.count > 0) {
        struct heap_item item = heap_pop(&search->heap);
        uint32_t node = item.node, parent = paths->parent[node];
        if (item.distance > search->distance[node] || paths->narrow[node] > 0)
            continue;
        search->source[node] =
            parent == GRAPH_NONE ? node : search->source[parent];
        paths->distance[node] = (float)item.distance;
        paths->narrow[node] = (float)search_narrow(search, node);
        search_arcs(search, node);
    }
}

static void search_begin(struct search *search)
{
    const struct paths_from *from = search->from;
    for (size_t i = 0; i < search->graph->count; i++) {
        search->paths->parent[i] = GRAPH_NONE;
        search->paths->distance[i] = INFINITY;
        search->distance[i] = (double)INFINITY;
    }
    for (size_t i = 0; i < from->count; i++) {
        uint32_t node = from->sources[i];
        double start = from->start ? from->start[i] : 0;
        if (!(start < search->distance[node]))
            continue;
        search->distance[node] = start;
        heap_push(&search->heap, (struct heap_item){ start, node });
    }
}

struct paths *paths_new(struct arena *arena, const struct graph *graph,
                        const struct paths_from *from)
{
    struct paths *paths = ARENA_NEW(arena, struct paths);
    size_t nodes = graph->count;
    struct search search = { .graph = graph, .from = from, .paths = paths };
    paths->parent = ARENA_ARRAY(arena, uint32_t, nodes);
    paths->distance = ARENA_ARRAY(arena, float, nodes);
    paths->narrow = ARENA_ARRAY(arena, float, nodes);
    search.distance = memory_new(nodes * sizeof *search.distance);
    search.source = memory_new(nodes * sizeof *search.source);
    /* Each arc is taken at most once from each end. */
    search.heap.items = memory_new((graph->first[nodes] + from->count) *
                                   sizeof *search.heap.items);
    search_begin(&search);
    search_run(&search);
    memory_free(search.distance);
    memory_free(search.source);
    memory_free(search.heap.items);
    return paths;
}
