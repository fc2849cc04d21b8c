/* ultra_wide_angle: angles grow evenly across and up the picture. */
#include "scene/camera.h"

static void ultra_wide_angle_finish(struct camera *camera)
{
    camera_turns(camera, 90);
    camera->turn_up *= vec3_length(camera->up) / vec3_length(camera->right);
    camera->right = vec3_normalise(camera->right);
    camera->up = vec3_normalise(camera->up);
}

static struct ray ultra_wide_angle_ray(const struct camera *camera, double x,
                                       double y)
{
    double at[2];
    camera_turned(camera, x, y, at);
    return (struct ray){ camera->location,
                         camera_sum(camera, sin(at[0]), sin(at[1]),
                                    cos(at[0]) * cos(at[1])) };
}

const struct camera_kind ultra_wide_angle_camera = {
    .name = "ultra_wide_angle",
    .help = "as wide as can be, bent at its borders",
    .lines = CAMERA_BENT,
    .finish = ultra_wide_angle_finish,
    .ray = ultra_wide_angle_ray,
    .bend_at = camera_turned,
};
