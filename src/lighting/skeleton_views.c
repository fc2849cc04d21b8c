/* The skeleton as points and lines: see skeleton_views.h. */
#include "lighting/skeleton_views.h"

#include "base/memory.h"
#include "image/ramp.h"
#include "shade/surface.h"
#include "skeleton/field.h"

/* An arrow is so long, in voxels, where light is least and most; arrows stand
 * about as far apart as the longest. */
static const double arrow_least = 1.5, arrow_most = 5;

/* The arcs, and nodes without one as points; numbers[i] is of node i. */
static void show_arcs(const struct graph *graph, const double *numbers,
                      struct show *show)
{
    for (uint32_t i = 0; i < graph->count; i++) {
        if (graph->first[i] == graph->first[i + 1])
            *ARRAY_PUSH(show->arena, &show->points) =
                (struct show_point){ graph->nodes[i].position, numbers[i] };
        for (uint32_t k = graph->first[i]; k < graph->first[i + 1]; k++) {
            uint32_t other = graph->neighbours[k];
            if (other > i)
                *ARRAY_PUSH(show->arena, &show->lines) = (struct show_line){
                    .from = graph->nodes[i].position,
                    .to = graph->nodes[other].position,
                    .from_number = numbers[i],
                    .to_number = numbers[other],
                };
        }
    }
}

void skeleton_show_graph(const struct skeleton *skeleton, struct show *show)
{
    const struct graph *graph = skeleton->graph;
    double *numbers = memory_new(graph->count * sizeof *numbers);
    for (size_t i = 0; i < graph->count; i++)
        numbers[i] = graph->nodes[i].radius;
    show->what = "radius";
    show_arcs(graph, numbers, show);
    memory_free(numbers);
}

/* The brightness of the light at each node; freed with memory_free. */
static double *field_brightness(const struct skeleton_light *light,
                                size_t count, struct show *show)
{
    double *numbers = memory_new(count * sizeof *numbers);
    for (size_t i = 0; i < count; i++)
        numbers[i] = rgb_brightness(light[i].arriving);
    show->what = "irradiance";
    show->logarithmic = true;
    return numbers;
}

void skeleton_show_light(const struct skeleton *skeleton, struct show *show)
{
    const struct graph *graph = skeleton->graph;
    struct skeleton_light *light = skeleton_field(skeleton);
    if (!light)
        return;
    double *numbers = field_brightness(light, graph->count, show);
    show_arcs(graph, numbers, show);
    memory_free(numbers);
    memory_free(light);
}

/* Of the nodes in each cube as wide as an arrow may be long, the first; the
 * cubes taken so far are bytes. */
static bool stream_is_free(const struct voxels *v, uint8_t *taken, vec3 at)
{
    size_t cube = 0;
    double units = arrow_most * v->edge;
    vec3 place = vec3_scale(vec3_sub(at, v->origin), 1 / units);
    double along[3] = { place.z, place.y, place.x };
    for (int axis = 0; axis < 3; axis++) {
        size_t cubes = (size_t)(v->size[2 - axis] / arrow_most) + 1;
        size_t index = along[axis] > 0 ? (size_t)along[axis] : 0;
        cube = cube * cubes + (index < cubes ? index : cubes - 1);
    }
    bool was_free = !taken[cube];
    taken[cube] = 1;
    return was_free;
}

static void show_arrow(const struct skeleton *skeleton, vec3 at,
                       const struct skeleton_light *light,
                       const struct ramp_range *range, struct show *show)
{
    double number = rgb_brightness(light->arriving);
    double length = ramp_range_place(range, number);
    length = arrow_least + (arrow_most - arrow_least) * length;
    vec3 way = vec3_scale(vec3_normalise(light->stream),
                          -length * skeleton->voxels->edge / 2);
    *ARRAY_PUSH(show->arena, &show->lines) = (struct show_line){
        .from = vec3_sub(at, way),
        .to = vec3_add(at, way),
        .from_number = number,
        .to_number = number,
        .arrow = true,
    };
}

void skeleton_show_stream(const struct skeleton *skeleton, struct show *show)
{
    const struct graph *graph = skeleton->graph;
    struct skeleton_light *light = skeleton_field(skeleton);
    if (!light)
        return;
    double *numbers = field_brightness(light, graph->count, show);
    uint8_t *taken = memory_new(voxels_count(skeleton->voxels));
    struct ramp_range range = { .logarithmic = true };
    for (size_t i = 0; i < graph->count; i++)
        ramp_range_add(&range, numbers[i]);
    for (size_t i = 0; i < graph->count; i++)
        if (vec3_length(light[i].stream) > 0 && numbers[i] > 0 &&
            stream_is_free(skeleton->voxels, taken, graph->nodes[i].position))
            show_arrow(skeleton, graph->nodes[i].position, &light[i], &range,
                       show);
    memory_free(taken);
    memory_free(numbers);
    memory_free(light);
}
