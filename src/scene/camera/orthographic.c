/* orthographic: rays side by side. */
#include "scene/camera.h"

/* The picture is as large as right and up if one of them was given, else as a
 * perspective picture is at the distance of look_at. */
static void orthographic_finish(struct camera *camera)
{
    double tangent = tan(camera->angle * (M_PI / 180) / 2);
    double width = vec3_length(camera->right);
    double distance = vec3_length(vec3_sub(camera->look_at, camera->location));
    double factor = 1;
    if (camera->angle > 0 && width > 0)
        factor = 2 * distance * tangent / width;
    else if (!camera->has_size || camera->angle_said)
        factor = distance / vec3_length(camera->direction);
    camera->right = vec3_scale(camera->right, factor);
    camera->up = vec3_scale(camera->up, factor);
}

static struct ray orthographic_ray(const struct camera *camera, double x,
                                   double y)
{
    return (
        struct ray){ vec3_add(camera->location, camera_sum(camera, x, y, 0)),
                     camera->direction };
}

CLONES static void
orthographic_ray_many(const struct camera *camera,
                      const struct camera_places *restrict at,
                      struct rays *restrict rays)
{
    const struct camera from = *camera;
    for (int i = 0; i < RAY_LANES; i++)
        rays_set(
            rays, i,
            vec3_add(from.location, camera_sum(&from, at->x[i], at->y[i], 0)),
            from.direction);
}

const struct camera_kind orthographic_camera = {
    .name = "orthographic",
    .help = "without perspective: rays side by side",
    .lines = CAMERA_PARALLEL,
    .finish = orthographic_finish,
    .ray = orthographic_ray,
    .ray_many = orthographic_ray_many,
};
