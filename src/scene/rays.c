/* Rays side by side: see rays.h. */
#include "scene/rays.h"

CLONES void rays_into(const affine *transform, const struct rays *restrict rays,
                      struct rays *restrict out)
{
    const affine to = *transform;
    for (int i = 0; i < RAY_LANES; i++)
        rays_set(out, i, affine_point(&to, rays_origin(rays, i)),
                 affine_direction(&to, rays_direction(rays, i)));
}
