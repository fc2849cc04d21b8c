/* fisheye: a disc; places as far from its middle are as far from the
 * direction. The rest of the picture is black. */
#include "scene/camera.h"

static void fisheye_finish(struct camera *camera)
{
    camera_turns(camera, 90);
}

/* From the middle of the disc, whose edge is at 1. */
static double fisheye_disc(const struct camera *camera, double x, double y)
{
    return 2 * sqrt(x * x * vec3_dot(camera->right, camera->right) +
                    y * y * vec3_dot(camera->up, camera->up));
}

static bool fisheye_sees(const struct camera *camera, double x, double y)
{
    return fisheye_disc(camera, x, y) <= 1;
}

/* From the direction. */
static void fisheye_angles(const struct camera *camera, double x, double y,
                           double at[2])
{
    at[0] = at[1] = fisheye_disc(camera, x, y) * camera->turn / 2;
}

static struct ray fisheye_turned(const struct camera *camera, double x,
                                 double y, const struct camera_turn turns[2])
{
    double r = fisheye_disc(camera, x, y);
    double side = r > 0 ? 2 * turns->sine / r : 0;
    return (struct ray){
        camera->location, camera_sum(camera, side * x, side * y, turns->cosine)
    };
}

/* Around the disc, and from the direction. */
static void fisheye_bend_at(const struct camera *camera, double x, double y,
                            double at[2])
{
    at[1] = fisheye_disc(camera, x, y) * camera->turn / 2;
    at[0] = camera_around(x * vec3_length(camera->right),
                          y * vec3_length(camera->up));
}

const struct camera_kind fisheye_camera = {
    .name = "fisheye",
    .help = "a disc",
    .lines = CAMERA_BENT,
    .finish = fisheye_finish,
    .sees = fisheye_sees,
    .angles = fisheye_angles,
    .turned = fisheye_turned,
    .bend_at = fisheye_bend_at,
};
