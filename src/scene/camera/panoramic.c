/* panoramic: half a turn across the picture. */
#include "scene/camera.h"

static struct ray panoramic_ray(const struct camera *camera, double x, double y)
{
    return (struct ray){ camera->location,
                         camera_sum(camera, sin(M_PI * x), tan(M_PI * y),
                                    cos(M_PI * x)) };
}

static void panoramic_bend_at(const struct camera *camera, double x, double y,
                              double at[2])
{
    (void)camera;
    at[0] = M_PI * (0.5 - x);
    at[1] = M_PI * y;
}

const struct camera_kind panoramic_camera = {
    .name = "panoramic",
    .help = "half a turn around, all that is above and below",
    .lines = CAMERA_BENT,
    .ray = panoramic_ray,
    .bend_at = panoramic_bend_at,
};
