/* Antialiasing: which pixels are sampled again, and how (section 5.10 of
 * notes/povray.md). Both methods first sample a grid over the whole picture;
 * pixels that differ from their neighbours are then refined one by one, so the
 * result depends neither on tiles nor on threads. */
#ifndef RENDER_SAMPLER_H
#define RENDER_SAMPLER_H

#include "render/render.h"

/* The first samples: float RGBA for every place of the grid. Method 1 and no
 * antialiasing: pixel centres, for method 1 one more all around, as far as
 * they are looked at; method 2: pixel corners. */
struct sampler {
    const struct tracer *tracer;
    const struct render_options *options;
    int x, y;          /* of the grid's first sample, in pixels */
    int columns, rows; /* of the grid */
    float *grid;
};

/* Frees with sampler_free. */
struct sampler sampler_new(const struct tracer *tracer,
                           const struct render_options *options);
void sampler_free(struct sampler *sampler);

/* Fills place (column, row) of the grid. */
void sampler_first(struct sampler *sampler, struct worker *worker, int column,
                   int row);

/* The pixel from the first samples and, where they differ, more of them.
 * (x, y) is the picture's pixel. `scratch` holds sampler_scratch floats. */
void sampler_pixel(const struct sampler *sampler, struct worker *worker, int x,
                   int y, float *scratch, float pixel[4]);

/* How many floats a thread needs to refine a pixel. */
size_t sampler_scratch(const struct sampler *sampler);

#endif
