/* What one thread owns while it renders: scratch memory and counters. Nothing
 * in it may change the picture. */
#ifndef BASE_WORKER_H
#define BASE_WORKER_H

#include <stdatomic.h>

#include "base/arena.h"

struct telling;

struct worker {
    unsigned number;
    const atomic_int *stop;  /* non-zero: leave off; NULL: never */
    struct arena *scratch;   /* reset after every camera ray */
    struct telling *telling; /* of --debug-pixel; NULL: nobody asks */
    /* A pixel that several camera rays in a row are of, in an order of its own:
     * its number is no other pixel's of this worker. 0: there is none. */
    unsigned long long pixel, pixels;
    struct {
        unsigned long long camera_rays, secondary_rays, shadow_rays;
        unsigned long long mesh_rays; /* of them, those of mesh points */
        double mesh_seconds;
    } counters;
    char apart[128]; /* from what other threads write: lines of the cache */
};

/* Around the rays of such a pixel. */
static inline void worker_pixel_begin(struct worker *worker)
{
    worker->pixel = ++worker->pixels;
}

static inline void worker_pixel_end(struct worker *worker)
{
    worker->pixel = 0;
}

/* Whether to leave off; asked in every loop that may take milliseconds. */
static inline bool worker_stopped(const struct worker *worker)
{
    return worker->stop &&
           atomic_load_explicit(worker->stop, memory_order_relaxed);
}

#endif
