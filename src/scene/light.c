/* Light sources as data: see light.h. */
#include "scene/light.h"

struct light light_default(void)
{
    return (struct light){
        .kind = LIGHT_POINT,
        .point_at = { 0, 0, 1 },
        .colour = { 1, 1, 1 },
        .radius = 30,
        .falloff = 45,
        .size1 = 1,
        .size2 = 1,
        .adaptive = -1,
        .photons = photon_flags_default,
    };
}

struct light light_moved(const struct light *light, const affine *transform)
{
    struct light moved = *light;
    moved.location = affine_point(transform, light->location);
    moved.point_at = affine_point(transform, light->point_at);
    moved.axis1 = affine_direction(transform, light->axis1);
    moved.axis2 = affine_direction(transform, light->axis2);
    return moved;
}
