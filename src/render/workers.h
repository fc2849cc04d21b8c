/* Workers for passes over pixels or points: begun, and their counters summed.
 */
#ifndef RENDER_WORKERS_H
#define RENDER_WORKERS_H

#include "render/render.h"

void worker_start(struct worker *worker, unsigned number,
                  const atomic_int *stop);

/* Adds what it counted to `stats` unless that is NULL. */
void worker_end(struct worker *worker, struct render_stats *stats);

#endif
