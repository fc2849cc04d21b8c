/* Workers: see workers.h. */
#include "render/workers.h"

void worker_start(struct worker *worker, unsigned number,
                  const atomic_int *stop)
{
    *worker = (struct worker){ .number = number,
                               .stop = stop,
                               .scratch = arena_new(0) };
}

void worker_end(struct worker *worker, struct render_stats *stats)
{
    if (stats) {
        stats->camera_rays += worker->counters.camera_rays;
        stats->secondary_rays += worker->counters.secondary_rays;
        stats->shadow_rays += worker->counters.shadow_rays;
    }
    arena_free(worker->scratch);
}
