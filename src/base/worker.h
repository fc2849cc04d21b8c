/* What one thread owns while it renders: scratch memory and counters. Nothing
 * in it may change the picture. */
#ifndef BASE_WORKER_H
#define BASE_WORKER_H

#include "base/arena.h"

struct worker {
    unsigned number;
    struct arena *scratch; /* reset after every camera ray */
    struct {
        unsigned long long camera_rays, secondary_rays, shadow_rays;
    } counters;
};

#endif
