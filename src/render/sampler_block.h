/* Places of the picture that are sampled together; for sampler.c and
 * sampler_refine.c. */
#ifndef RENDER_SAMPLER_BLOCK_H
#define RENDER_SAMPLER_BLOCK_H

#include "render/sampler_places.h"
#include "tracer/tracer.h"

enum { BLOCK_MOST = SAMPLER_BLOCK * SAMPLER_BLOCK };

/* Close together, the sooner seen the closer. */
struct sampler_block {
    unsigned count;
    struct picture_place places[BLOCK_MOST];
    struct rays rays;
    struct world_hit hits[BLOCK_MOST];
};

/* Numbers that are too large make an opacity of what is none, which must not
 * look like a place that isn't sampled: it would be asked for for ever. */
static inline void sampler_take(const struct radiance *seen, float out[4])
{
    out[0] = (float)seen->colour.r;
    out[1] = (float)seen->colour.g;
    out[2] = (float)seen->colour.b;
    out[3] = seen->opacity > UNSEEN ? (float)seen->opacity : 0;
}

/* Where in their pixels the places of the grid are, both ways. */
static inline double sampler_middle(const struct sampler *sampler)
{
    return sampler_corners(sampler) ? 0 : 0.5;
}

/* The cameras' rays. */
static inline void block_aim(const struct sampler *sampler,
                             struct sampler_block *block)
{
    _Static_assert((int)BLOCK_MOST <= (int)WORLD_RAYS, "a packet");
    tracer_rays(sampler->tracer, block->places, block->count, &block->rays);
}

/* What they meet first, if it matters. */
static inline void block_meet(const struct sampler *sampler,
                              struct sampler_block *block)
{
    if (tracer_is_single(sampler->tracer))
        tracer_meet_many(sampler->tracer, &block->rays, block->count,
                         block->hits);
}

/* What the camera sees there, of what is met first. */
static inline void block_see(const struct sampler *sampler,
                             struct worker *worker,
                             const struct sampler_block *block,
                             struct radiance *seen)
{
    const struct tracer_met met = { block->places, &block->rays, block->hits,
                                    block->count };
    tracer_see_many(sampler->tracer, worker, &met, seen);
}

#endif
