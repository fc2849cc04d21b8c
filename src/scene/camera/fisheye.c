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
    return 2 *
           hypot(x * vec3_length(camera->right), y * vec3_length(camera->up));
}

static bool fisheye_sees(const struct camera *camera, double x, double y)
{
    return fisheye_disc(camera, x, y) <= 1;
}

static struct ray fisheye_ray(const struct camera *camera, double x, double y)
{
    double r = fisheye_disc(camera, x, y), angle = r * camera->turn / 2;
    double side = r > 0 ? 2 * sin(angle) / r : 0;
    return (struct ray){ camera->location,
                         camera_sum(camera, side * x, side * y, cos(angle)) };
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
    .ray = fisheye_ray,
    .bend_at = fisheye_bend_at,
};
