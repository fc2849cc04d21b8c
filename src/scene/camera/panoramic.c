/* panoramic: half a turn across the picture. */
#include "scene/camera.h"

static void panoramic_angles(const struct camera *camera, double x, double y,
                             double at[2])
{
    (void)camera;
    at[0] = M_PI * x;
    at[1] = M_PI * y;
}

static struct ray panoramic_turned(const struct camera *camera, double x,
                                   double y, const struct camera_turn turns[2])
{
    (void)x;
    (void)y;
    return (struct ray){ camera->location,
                         camera_sum(camera, turns[0].sine,
                                    turns[1].sine / turns[1].cosine,
                                    turns[0].cosine) };
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
    .angles = panoramic_angles,
    .turned = panoramic_turned,
    .bend_at = panoramic_bend_at,
};
