/* The picture of whole paths: passes over all pixels, a few samples each, until
 * there are enough, the estimated error is small enough, or time is up. */
#ifndef RENDER_PASSES_H
#define RENDER_PASSES_H

#include "render/render.h"

/* As render_run. The tracer is ready. The picture depends on the number of
 * samples alone, and so on time only where a target for it was set. */
bool passes_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats);

#endif
