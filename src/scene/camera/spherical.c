/* spherical: longitude and latitude. */
#include "scene/camera.h"

static void spherical_finish(struct camera *camera)
{
    camera_turns(camera, 360);
    camera->turn_up = camera->angle_up > 0 ? camera->angle_up * (M_PI / 180)
                                           : camera->turn / 2;
    camera->right = vec3_normalise(camera->right);
    camera->up = vec3_normalise(camera->up);
}

static struct ray spherical_ray(const struct camera *camera, double x, double y)
{
    double at[2];
    camera_turned(camera, x, y, at);
    return (struct ray){ camera->location,
                         camera_sum(camera, sin(at[0]) * cos(at[1]), sin(at[1]),
                                    cos(at[0]) * cos(at[1])) };
}

const struct camera_kind spherical_camera = {
    .name = "spherical",
    .help = "longitude and latitude: all around",
    .lines = CAMERA_BENT,
    .finish = spherical_finish,
    .ray = spherical_ray,
    .bend_at = camera_turned,
};
