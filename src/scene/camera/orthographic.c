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

const struct camera_kind orthographic_camera = {
    .name = "orthographic",
    .help = "without perspective: rays side by side",
    .lines = CAMERA_PARALLEL,
    .finish = orthographic_finish,
    .ray = orthographic_ray,
};
