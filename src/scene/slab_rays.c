/* See slab_rays.h. */
#include "scene/slab_rays.h"

CLONES void rays_inverse(const struct rays *restrict rays, struct lane_run run,
                         double inverse[restrict 3][RAY_LANES])
{
    for (int axis = 0; axis < 3; axis++)
        EACH_LANE(i, run)
            inverse[axis][i] = slab_inverse(rays->direction[axis][i]);
}

CLONES void rays_meet_box(const struct rays_boxed *restrict rays,
                          const struct box3 *box, struct lane_run run,
                          lane_flag *restrict met)
{
    const vec3 low = box->low, high = box->high;
    const double(*inverse)[RAY_LANES] = rays->inverse;
    EACH_LANE(i, run) {
        double enter = rays->span->near[i], leave = rays->span->far[i];
        vec3 o = rays_origin(rays->rays, i);
        slab_clip(low.x, high.x, o.x, inverse[0][i], &enter, &leave);
        slab_clip(low.y, high.y, o.y, inverse[1][i], &enter, &leave);
        slab_clip(low.z, high.z, o.z, inverse[2][i], &enter, &leave);
        met[i] = slabs_overlap(enter, leave) ? -1 : 0;
    }
}
