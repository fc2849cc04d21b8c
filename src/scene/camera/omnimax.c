/* omnimax: a disc cut off below, a dome's film. */
#include "scene/camera.h"

static void omnimax_finish(struct camera *camera)
{
    camera_turns(camera, 90);
}

/* The angle from the direction at r of the disc, radians: a quarter turn at its
 * edge, 1. */
static double omnimax_angle(double r)
{
    double square = r * r;
    return r * (1.411269 + square * (-0.09439 + square * 0.25674));
}

/* The place on the disc, of one from the picture's middle. It is as wide as the
 * picture, with its top at the picture's if that is wider than high; but so far
 * that all down to 45 degrees is in the picture (measured). */
static void omnimax_place(const struct camera *camera, double x, double y,
                          double disc[2])
{
    const double lowest = 0.5583; /* where the angle is 45 degrees */
    double shape = vec3_length(camera->right) / vec3_length(camera->up);
    double scale = fmax(1 / shape, (1 + lowest) / 2);
    disc[0] = 2 * x * scale * shape;
    disc[1] = 2 * y * scale + fmax(0, 1 - scale);
}

static double omnimax_radius(const double disc[2])
{
    return sqrt(disc[0] * disc[0] + disc[1] * disc[1]);
}

/* From the direction. */
static void omnimax_angles(const struct camera *camera, double x, double y,
                           double at[2])
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    at[0] = at[1] = omnimax_angle(omnimax_radius(disc));
}

static struct ray omnimax_turned(const struct camera *camera, double x,
                                 double y, const struct camera_turn turns[2])
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    double r = omnimax_radius(disc), side = r > 0 ? turns->sine / r : 0;
    vec3 sum = vec3_scale(vec3_normalise(camera->right), side * disc[0]);
    sum = vec3_along(sum, vec3_normalise(camera->up), side * disc[1]);
    return (struct ray){ camera->location,
                         vec3_along(sum, camera->direction, turns->cosine) };
}

static bool omnimax_sees(const struct camera *camera, double x, double y)
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    double r = omnimax_radius(disc), angle = omnimax_angle(r);
    return r <= 1 && disc[1] * sin(angle) >= -r * cos(angle);
}

/* Around the disc, and from the direction. */
static void omnimax_bend_at(const struct camera *camera, double x, double y,
                            double at[2])
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    at[0] = camera_around(disc[0], disc[1]);
    at[1] = omnimax_angle(omnimax_radius(disc));
}

const struct camera_kind omnimax_camera = {
    .name = "omnimax",
    .help = "a disc, cut off below: a dome's film",
    .lines = CAMERA_BENT,
    .finish = omnimax_finish,
    .sees = omnimax_sees,
    .angles = omnimax_angles,
    .turned = omnimax_turned,
    .bend_at = omnimax_bend_at,
};
