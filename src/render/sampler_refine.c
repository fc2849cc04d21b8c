/* Pixels of first samples and, where they differ, more of them: see sampler.h.
 */
#include "render/sampler_refine.h"

void sampler_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch)
{
    if (sampler->direct || (sampler->sparse && !sampler_wants(sampler, tile)))
        return;
    if (sampler_corners(sampler))
        corners_tile(sampler, worker, tile, scratch);
    else
        centres_tile(sampler, worker, tile, scratch);
}

size_t sampler_scratch(const struct sampler *sampler)
{
    if (sampler->direct)
        return 0;
    return sampler_corners(sampler) ? corners_scratch(sampler)
                                    : centres_scratch();
}
