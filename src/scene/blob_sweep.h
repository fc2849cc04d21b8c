/* What a ray meets of a blob: stretches of it in which single parts have a
 * density, and the crossings where these add up to the threshold. */
#ifndef SCENE_BLOB_SWEEP_H
#define SCENE_BLOB_SWEEP_H

#include "scene/blob_tree.h"
#include "scene/rays.h"

enum {
    STRETCHES_MAX = 1024, /* parts that one line may meet; more are left out */
};

/* Between low and high a part's density is strength q^2, where
 * q = most - a (t - nearest)^2: in this form no digits are lost. */
struct stretch {
    double low, high, strength, a, nearest, most;
};

struct stretches {
    double tmin, tmax; /* what is wanted of the ray */
    int count, limit;
    struct stretch *items;
};

/* Those of the ray and so many bodies; none beyond the limit. */
void stretches_add(struct stretches *all, const struct blob_body *bodies,
                   size_t count, const struct ray *ray);

/* The same of rays side by side and a round body: which have one. */
struct lane_stretches {
    LANE_LINES double low[RAY_LANES], high[RAY_LANES], a[RAY_LANES],
        nearest[RAY_LANES], most[RAY_LANES];
};
void lane_stretches_of(const struct blob_body *body, const struct rays *rays,
                       const struct rays_span *span,
                       struct lane_stretches *stretches, lane_flag *met);

/* Calls visit for the crossings, by increasing t, until it returns true. The
 * stretches are sorted. */
void stretches_sweep(struct stretches *all, double threshold, hit_visit *visit,
                     void *context);

#endif
