/* Whether rays side by side meet a box, each as slab.h has it to the bit. */
#ifndef SCENE_SLAB_RAYS_H
#define SCENE_SLAB_RAYS_H

#include "scene/rays.h"
#include "scene/slab.h"

/* The inverse of the directions, as slab_inverse has it. */
void rays_inverse(const struct rays *rays, struct lane_run run,
                  double inverse[3][RAY_LANES]);

/* Which of the rays may meet the box within their span. */
struct rays_boxed {
    const struct rays *rays;
    const double (*inverse)[RAY_LANES];
    const struct rays_span *span;
};

void rays_meet_box(const struct rays_boxed *rays, const struct box3 *box,
                   struct lane_run run, lane_flag *met);

#endif
