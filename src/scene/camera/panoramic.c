/* panoramic: half a turn across the picture. */
#include "scene/camera.h"

static struct ray panoramic_ray(const struct camera *camera, double x, double y)
{
    return (struct ray){ camera->location,
                         camera_sum(camera, sin(M_PI * x), tan(M_PI * y),
                                    cos(M_PI * x)) };
}

const struct camera_kind panoramic_camera = {
    .name = "panoramic",
    .help = "half a turn around, all that is above and below",
    .lines = CAMERA_BENT,
    .ray = panoramic_ray,
};
