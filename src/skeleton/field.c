/* The light at all nodes: see field.h. */
#include "skeleton/field.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "skeleton/heuristic.h"

struct field_work {
    const struct skeleton *skeleton;
    struct skeleton_light *light;
};

static void field_node(void *context, size_t item, unsigned thread)
{
    struct field_work *work = context;
    const struct skeleton *skeleton = work->skeleton;
    vec3 place = skeleton->graph->nodes[item].position;
    struct worker worker = { .number = thread, .scratch = arena_new(0) };
    struct skeleton_point point = { .position = place,
                                    .around = place,
                                    .voxel = VOXEL_NONE,
                                    .node = (uint32_t)item };
    work->light[item] = skeleton->heuristic->answer(skeleton, &worker, &point);
    arena_free(worker.scratch);
}

struct skeleton_light *skeleton_field(const struct skeleton *skeleton)
{
    size_t count = skeleton->graph->count;
    struct field_work work = { .skeleton = skeleton };
    work.light = memory_new(count * sizeof *work.light);
    if (parallel_run(skeleton->threads, count, skeleton->stop, field_node,
                     &work))
        return work.light;
    memory_free(work.light);
    return NULL;
}
