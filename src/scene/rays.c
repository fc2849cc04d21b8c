/* Rays side by side: see rays.h. */
#include "scene/rays.h"

CLONES void rays_into(const affine *transform, struct lane_run run,
                      const struct rays *restrict rays,
                      struct rays *restrict out)
{
    const affine to = *transform;
    EACH_LANE(i, run)
        rays_set(out, i, affine_point(&to, rays_origin(rays, i)),
                 affine_direction(&to, rays_direction(rays, i)));
}

CLONES void lane_points_into(const affine *transform, struct lane_run run,
                             const struct lane_points *restrict points,
                             struct lane_points *restrict out)
{
    const affine to = *transform;
    EACH_LANE(i, run)
        lane_put(out->at, i, affine_point(&to, lane_get(points->at, i)));
}

CLONES void rays_first_of(const struct rays_crossings *restrict all,
                          struct lane_run run,
                          const struct rays_span *restrict span,
                          struct rays_met *restrict met)
{
    EACH_LANE(i, run) {
        met->t[i] = (double)INFINITY;
        met->part[i] = 0;
    }
    for (int k = 0; k < all->count; k++)
        EACH_LANE(i, run) {
            double t = all->t[k][i], part = all->part[k][i];
            bool is =
                (t > span->near[i]) & (t < span->far[i]) & (t < met->t[i]);
            met->t[i] = is ? t : met->t[i];
            met->part[i] = is ? part : met->part[i];
        }
}

CLONES void rays_crosses_of(const struct rays_crossings *restrict all,
                            struct lane_run run,
                            const struct rays_span *restrict span,
                            lane_flag *restrict met)
{
    EACH_LANE(i, run)
        met[i] = 0;
    for (int k = 0; k < all->count; k++)
        EACH_LANE(i, run) {
            double t = all->t[k][i];
            met[i] |= ((t > span->near[i]) & (t < span->far[i])) ? -1 : 0;
        }
}

CLONES void rays_crosses_met(const struct rays_met *restrict first,
                             struct lane_run run, lane_flag *restrict met)
{
    EACH_LANE(i, run)
        met[i] = first->t[i] < (double)INFINITY ? -1 : 0;
}

const struct rays_span *rays_span_asked(const struct rays_span *span,
                                        unsigned lanes, bool lane_by_lane,
                                        struct rays_span *out)
{
    unsigned others = ~lanes & ((1u << RAY_LANES) - 1);
    if (!lane_by_lane || !others)
        return span;
    *out = *span;
    for (; others; others &= others - 1)
        out->far[__builtin_ctz(others)] = -(double)INFINITY;
    return out;
}
