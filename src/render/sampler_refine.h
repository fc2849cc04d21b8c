/* What both methods of antialiasing need to sample pixels again; for
 * sampler_centres.c (method 1) and sampler_corners.c (method 2). */
#ifndef RENDER_SAMPLER_REFINE_H
#define RENDER_SAMPLER_REFINE_H

#include "base/random.h"
#include "render/sampler_block.h"

/* +R, as far as there is such a depth. */
enum { DEPTH_MOST = 9 };

static inline int sampler_depth(const struct sampler *sampler)
{
    int depth = sampler->options->depth;
    return depth < 1 ? 1 : depth > DEPTH_MOST ? DEPTH_MOST : depth;
}

/* (x, y) in pixels from the top left. Into its place: to copy what was only
 * just written number by number waits for the memory. */
static inline void sampler_at(const struct sampler *sampler, double x, double y,
                              struct picture_place *place)
{
    const struct render_options *options = sampler->options;
    double middle = sampler_middle(sampler);
    place->at[0] = x / options->width;
    place->at[1] = y / options->height;
    place->grid[0] = x - middle;
    place->grid[1] = y - middle;
    place->around = NULL;
}

/* Sum of the differences after gamma correction; opacity counts when it is
 * wanted. */
static inline bool sampler_differ(const struct sampler *sampler, const float *a,
                                  const float *b)
{
    double more =
        sampler->tracer->alpha ? fabs((double)a[3] - (double)b[3]) : 0;
    return perceived_differ(sampler->perceived, a, b, more,
                            sampler->options->threshold);
}

/* Of a pixel; and one of its numbers in [-0.5, 0.5), by its place in the
 * picture alone. */
static inline uint64_t jitter_key(int x, int y)
{
    return random_key((uint64_t)(unsigned)x, (uint64_t)(unsigned)y);
}

static inline double jitter_number(uint64_t key, int number)
{
    return random_unit(random_key(key, (uint64_t)(unsigned)number)) - 0.5;
}

/* What the camera sees at the block's places, as the picture holds it. */
static inline void block_values(const struct sampler *sampler,
                                struct worker *worker,
                                struct sampler_block *block, float (*values)[4])
{
    struct radiance seen[BLOCK_MOST];
    block_aim(sampler, block);
    block_meet(sampler, block);
    block_see(sampler, worker, block, seen);
    for (unsigned i = 0; i < block->count; i++)
        sampler_take(&seen[i], values[i]);
}

/* `count` pixels of the picture beside each other, which is done with them. */
static inline void sampler_finish(const struct sampler *sampler,
                                  const float *pixels, int x, int y, int count)
{
    unsigned char *states = sampler_state(sampler, x, y);
    memcpy(sampler_pixel(sampler, x, y), pixels,
           (size_t)count * 4 * sizeof *pixels);
    for (int i = 0; i < count; i++)
        states[i] |= SAMPLER_DONE;
}

/* sampler_tile by each method, and the floats of scratch that it needs. */
void centres_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch);
size_t centres_scratch(void);
void corners_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch);
size_t corners_scratch(const struct sampler *sampler);

#endif
