/* What one thread owns while it renders: scratch memory and counters. Nothing
 * in it may change the picture. */
#ifndef BASE_WORKER_H
#define BASE_WORKER_H

#include <stdatomic.h>

#include "base/arena.h"

struct telling;

/* The last place that was asked for its photons and found all that it looked
 * for: how far these were, so that the next one knows about how far to look. */
struct worker_photons {
    const void *map;    /* NULL: none */
    float at[3], reach; /* its square */
};

struct worker {
    unsigned number;
    const atomic_int *stop;    /* non-zero: leave off; NULL: never */
    struct arena *scratch;     /* reset after every camera ray */
    struct telling *telling;   /* of --debug-pixel; NULL: nobody asks */
    unsigned long long pixels; /* numbers that were given to them */
    struct worker_photons photons;
    struct {
        unsigned long long camera_rays, secondary_rays, shadow_rays;
        unsigned long long mesh_rays; /* of them, those of mesh points */
        double mesh_seconds;
    } counters;
    char apart[128]; /* from what other threads write: lines of the cache */
};

/* A number for a pixel of which several rays are, in an order of its own: no
 * other pixel of this worker has it. */
static inline unsigned long long worker_pixel(struct worker *worker)
{
    return ++worker->pixels;
}

/* Whether to leave off; asked in every loop that may take milliseconds. */
static inline bool worker_stopped(const struct worker *worker)
{
    return worker->stop &&
           atomic_load_explicit(worker->stop, memory_order_relaxed);
}

#endif
