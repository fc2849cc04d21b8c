/* The graph of the skeleton: see graph.h. */
#include "skeleton/graph.h"

#include <string.h>

#include "base/memory.h"

enum { SMOOTHINGS = 3 };

double graph_length(const struct graph *graph, uint32_t a, uint32_t b)
{
    return vec3_length(
        vec3_sub(graph->nodes[a].position, graph->nodes[b].position));
}

/* The voxels around a lattice point: those that exist. */
static int voxels_around(const struct voxels *v, const int place[3],
                         size_t around[8])
{
    int count = 0;
    for (int corner = 0; corner < 8; corner++) {
        int x = place[0] - (corner & 1);
        int y = place[1] - (corner >> 1 & 1);
        int z = place[2] - (corner >> 2 & 1);
        if (x >= 0 && y >= 0 && z >= 0 && x < v->size[0] && y < v->size[1] &&
            z < v->size[2])
            around[count++] = voxels_index(v, x, y, z);
    }
    return count;
}

/* The widest voxel around; where there is no matter, as wide as the grid. */
static double node_radius(const struct voxels *v, const int32_t *squared,
                          const int place[3])
{
    size_t around[8];
    double widest = 1;
    double all = vec3_length(vec3_make(v->size[0], v->size[1], v->size[2]));
    int count = voxels_around(v, place, around);
    for (int i = 0; i < count; i++)
        widest = fmax(widest, squared[around[i]]);
    return v->edge * fmin(sqrt(widest), all);
}

/* Numbers for the points of the complex: their place in the list of bytes. */
static uint32_t *graph_number(struct graph *graph,
                              const struct complex *complex)
{
    uint32_t *numbers = memory_new(complex->count * sizeof *numbers);
    graph->count = 0;
    for (size_t i = 0; i < complex->count; i++)
        if (complex->cells[i] & 1)
            numbers[i] = (uint32_t)graph->count++;
    return numbers;
}

static void graph_link(struct arena *arena, struct graph *graph,
                       const struct complex *complex, const uint32_t *numbers)
{
    size_t edges = (size_t)complex_count(complex).of[1], used = 0;
    graph->first = ARENA_ARRAY(arena, uint32_t, graph->count + 1);
    graph->neighbours = ARENA_ARRAY(arena, uint32_t, 2 * edges);
    for (size_t i = 0; i < complex->count; i++) {
        cell point = (cell)(8 * i);
        if (!complex_has(complex->cells, point))
            continue;
        graph->first[numbers[i]] = (uint32_t)used;
        for (int axis = 0; axis < 3; axis++) {
            size_t stride = complex->stride[axis] / 8;
            if (complex_has(complex->cells, cell_below(complex, point, axis)))
                graph->neighbours[used++] = numbers[i - stride];
            if (complex_has(complex->cells, cell_above(point, axis)))
                graph->neighbours[used++] = numbers[i + stride];
        }
    }
    graph->first[graph->count] = (uint32_t)used;
}

static void graph_place(struct graph *graph, const struct complex *complex,
                        const struct voxels *v, const int32_t *squared)
{
    struct graph_node *node = graph->nodes;
    int place[3];
    for (size_t i = 0; i < complex->count; i++) {
        if (!(complex->cells[i] & 1))
            continue;
        complex_place(complex, (cell)(8 * i), place);
        vec3 corner = vec3_make(place[0], place[1], place[2]);
        node->position = vec3_along(v->origin, corner, v->edge);
        node->radius = node_radius(v, squared, place);
        node++;
    }
}

/* Whether a void voxel holds the point, its faces included. */
static bool point_in_void(const struct voxels *v, vec3 point)
{
    vec3 at = vec3_scale(vec3_sub(point, v->origin), 1 / v->edge);
    for (int corner = 0; corner < 8; corner++) {
        int x = (int)floor(at.x + (corner & 1 ? 1e-6 : -1e-6));
        int y = (int)floor(at.y + (corner & 2 ? 1e-6 : -1e-6));
        int z = (int)floor(at.z + (corner & 4 ? 1e-6 : -1e-6));
        if (x >= 0 && y >= 0 && z >= 0 && x < v->size[0] && y < v->size[1] &&
            z < v->size[2] && v->empty[voxels_index(v, x, y, z)])
            return true;
    }
    return false;
}

/* Ends stay where they are. */
static void graph_smooth(struct graph *graph, const struct voxels *v)
{
    vec3 *moved = memory_new(graph->count * sizeof *moved);
    for (int round = 0; round < SMOOTHINGS; round++) {
        for (size_t i = 0; i < graph->count; i++) {
            uint32_t from = graph->first[i], to = graph->first[i + 1];
            vec3 sum = graph->nodes[i].position;
            moved[i] = sum;
            if (to - from < 2)
                continue;
            for (uint32_t k = from; k < to; k++)
                sum =
                    vec3_add(sum, graph->nodes[graph->neighbours[k]].position);
            sum = vec3_scale(sum, 1.0 / (to - from + 1));
            if (point_in_void(v, sum))
                moved[i] = sum;
        }
        for (size_t i = 0; i < graph->count; i++)
            graph->nodes[i].position = moved[i];
    }
    memory_free(moved);
}

static bool same_group(const uint32_t *group, uint32_t a, uint32_t b)
{
    return !group || group[a] == group[b];
}

size_t graph_label(const struct graph *graph, const uint32_t *group,
                   const uint32_t *also, uint32_t *out)
{
    uint32_t *queue = memory_new(graph->count * sizeof *queue), label = 0;
    for (size_t i = 0; i < graph->count; i++)
        out[i] = GRAPH_NONE;
    for (size_t seed = 0; seed < graph->count; seed++) {
        size_t head = 0, tail = 0;
        if (out[seed] != GRAPH_NONE)
            continue;
        out[seed] = label;
        queue[tail++] = (uint32_t)seed;
        while (head < tail) {
            uint32_t at = queue[head++];
            for (uint32_t k = graph->first[at]; k < graph->first[at + 1]; k++) {
                uint32_t next = graph->neighbours[k];
                if (out[next] != GRAPH_NONE || !same_group(group, at, next) ||
                    !same_group(also, at, next))
                    continue;
                out[next] = label;
                queue[tail++] = next;
            }
        }
        label++;
    }
    memory_free(queue);
    return label;
}

struct graph *graph_new(struct arena *arena, const struct complex *complex,
                        const struct voxels *voxels, const int32_t *squared)
{
    struct graph *graph = ARENA_NEW(arena, struct graph);
    uint32_t *numbers = graph_number(graph, complex);
    graph->nodes = ARENA_ARRAY(arena, struct graph_node, graph->count);
    graph_link(arena, graph, complex, numbers);
    memory_free(numbers);
    graph_place(graph, complex, voxels, squared);
    graph_smooth(graph, voxels);
    graph->part = ARENA_ARRAY(arena, uint32_t, graph->count);
    graph->parts = graph_label(graph, NULL, NULL, graph->part);
    return graph;
}

/* A queue of voxels, breadth first. */
struct flood {
    const struct voxels *voxels;
    uint32_t *nearest;
    uint32_t *queue;
    size_t head, tail;
};

static void flood_reach(struct flood *flood, size_t voxel, uint32_t node)
{
    if (!flood->voxels->empty[voxel] || flood->nearest[voxel] != GRAPH_NONE)
        return;
    flood->nearest[voxel] = node;
    flood->queue[flood->tail++] = (uint32_t)voxel;
}

static void flood_spread(struct flood *flood)
{
    const int *size = flood->voxels->size;
    size_t rows = (size_t)size[0], slices = rows * (size_t)size[1];
    while (flood->head < flood->tail) {
        size_t at = flood->queue[flood->head++];
        uint32_t node = flood->nearest[at];
        size_t x = at % rows, y = at / rows % (size_t)size[1], z = at / slices;
        if (x > 0)
            flood_reach(flood, at - 1, node);
        if (x + 1 < rows)
            flood_reach(flood, at + 1, node);
        if (y > 0)
            flood_reach(flood, at - rows, node);
        if (y + 1 < (size_t)size[1])
            flood_reach(flood, at + rows, node);
        if (z > 0)
            flood_reach(flood, at - slices, node);
        if (z + 1 < (size_t)size[2])
            flood_reach(flood, at + slices, node);
    }
}

void graph_nearest(const struct complex *complex, const struct voxels *voxels,
                   uint32_t *out)
{
    size_t count = voxels_count(voxels), around[8];
    struct flood flood = { voxels, out, NULL, 0, 0 };
    uint32_t node = 0;
    int place[3];
    memset(out, 0xff, count * sizeof *out);
    flood.queue = memory_new(count * sizeof *flood.queue);
    for (size_t i = 0; i < complex->count; i++) {
        if (!(complex->cells[i] & 1))
            continue;
        complex_place(complex, (cell)(8 * i), place);
        int found = voxels_around(voxels, place, around);
        for (int k = 0; k < found; k++)
            flood_reach(&flood, around[k], node);
        node++;
    }
    flood_spread(&flood);
    memory_free(flood.queue);
}
