/* ultra_wide_angle: angles grow evenly across and up the picture. */
#include "scene/camera.h"

static void ultra_wide_angle_finish(struct camera *camera)
{
    camera_turns(camera, 90);
    camera->turn_up *= vec3_length(camera->up) / vec3_length(camera->right);
    camera->right = vec3_normalise(camera->right);
    camera->up = vec3_normalise(camera->up);
}

static struct ray ultra_wide_angle_turned(const struct camera *camera, double x,
                                          double y,
                                          const struct camera_turn turns[2])
{
    (void)x;
    (void)y;
    return (struct ray){ camera->location,
                         camera_sum(camera, turns[0].sine, turns[1].sine,
                                    turns[0].cosine * turns[1].cosine) };
}

const struct camera_kind ultra_wide_angle_camera = {
    .name = "ultra_wide_angle",
    .help = "as wide as can be, bent at its borders",
    .lines = CAMERA_BENT,
    .finish = ultra_wide_angle_finish,
    .angles = camera_turned,
    .turned = ultra_wide_angle_turned,
    .bend_at = camera_turned,
};
