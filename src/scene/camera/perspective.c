/* perspective: all rays from one point through a plane. */
#include "scene/camera.h"

static void perspective_finish(struct camera *camera)
{
    if (!(camera->angle > 0))
        return;
    double tangent = tan(camera->angle * (M_PI / 180) / 2);
    double length = vec3_length(camera->right) / (2 * tangent);
    camera->direction = vec3_scale(vec3_normalise(camera->direction), length);
}

static struct ray perspective_ray(const struct camera *camera, double x,
                                  double y)
{
    return (struct ray){ camera->location, camera_sum(camera, x, y, 1) };
}

CLONES static void perspective_ray_many(const struct camera *camera,
                                        const struct camera_places *restrict at,
                                        struct rays *restrict rays)
{
    const struct camera from = *camera;
    for (int i = 0; i < RAY_LANES; i++)
        rays_set(rays, i, from.location,
                 camera_sum(&from, at->x[i], at->y[i], 1));
}

const struct camera_kind perspective_camera = {
    .name = "perspective",
    .help = "as a pinhole sees, the default",
    .lines = CAMERA_CENTRAL,
    .finish = perspective_finish,
    .ray = perspective_ray,
    .ray_many = perspective_ray_many,
};
