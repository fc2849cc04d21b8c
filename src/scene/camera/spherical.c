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

static struct ray spherical_turned(const struct camera *camera, double x,
                                   double y, const struct camera_turn turns[2])
{
    (void)x;
    (void)y;
    return (struct ray){ camera->location,
                         camera_sum(camera, turns[0].sine * turns[1].cosine,
                                    turns[1].sine,
                                    turns[0].cosine * turns[1].cosine) };
}

const struct camera_kind spherical_camera = {
    .name = "spherical",
    .help = "longitude and latitude: all around",
    .lines = CAMERA_BENT,
    .finish = spherical_finish,
    .angles = camera_turned,
    .turned = spherical_turned,
    .bend_at = camera_turned,
};
