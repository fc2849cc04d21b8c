/* Cameras, as POV-Ray's (section 5.8 of tests/povray.md; the size of an
 * orthographic picture was measured with some twenty cameras). */
#include "scene/camera.h"

#include <stddef.h>

struct camera camera_default(void)
{
    return (struct camera){
        .kind = CAMERA_PERSPECTIVE,
        .direction = { 0, 0, 1 },
        .right = { 1.33, 0, 0 },
        .up = { 0, 1, 0 },
        .sky = { 0, 1, 0 },
        .look_at = { 0, 0, 1 },
        .focal_point = { 0, 0, 1 },
        .confidence = 0.9,
        .variance = 1e-4,
    };
}

static const char *camera_check(const struct camera *camera)
{
    if (camera->angle < 0)
        return "its angle is negative";
    if (camera->kind <= CAMERA_ORTHOGRAPHIC && camera->angle >= 180)
        return "its angle must be less than 180 degrees";
    if (!(vec3_length(camera->direction) > 0))
        return "its direction has no length";
    if (camera->has_look_at &&
        !(vec3_length(vec3_sub(camera->look_at, camera->location)) > 0))
        return "look_at is the same point as location";
    return NULL;
}

/* Turns the camera to look_at, right being level with respect to the sky and
 * as mirrored as before (as POV-Ray does also when up is along direction, which
 * `up z` leads to). If it looks straight into the sky, right stays, but for
 * this. */
static void camera_aim(struct camera *camera)
{
    vec3 aim = vec3_normalise(vec3_sub(camera->look_at, camera->location));
    vec3 straight = vec3_cross(camera->up, camera->direction);
    bool mirrored = !(vec3_dot(straight, camera->right) > 0);
    vec3 right = vec3_cross(vec3_normalise(camera->sky), aim);
    if (!(vec3_length(right) > 1e-9))
        right = camera->right;
    right = vec3_normalise(right);
    vec3 up = vec3_normalise(vec3_cross(aim, right));
    if (mirrored)
        right = vec3_negate(right);
    camera->direction = vec3_scale(aim, vec3_length(camera->direction));
    camera->right = vec3_scale(right, vec3_length(camera->right));
    camera->up = vec3_scale(up, vec3_length(camera->up));
}

/* An orthographic picture is as large as right and up if one of them was
 * given, else as a perspective picture is at the distance of look_at. */
static void camera_size(struct camera *camera)
{
    double tangent = tan(camera->angle * (M_PI / 180) / 2);
    double width = vec3_length(camera->right);
    double distance = vec3_length(vec3_sub(camera->look_at, camera->location));
    double factor = 1;
    if (camera->angle > 0 && width > 0)
        factor = 2 * distance * tangent / width;
    else if (!camera->has_size || camera->angle_said)
        factor = distance / vec3_length(camera->direction);
    camera->right = vec3_scale(camera->right, factor);
    camera->up = vec3_scale(camera->up, factor);
}

/* What turns and how far; across or up the picture of a cylinder the other
 * vector's length counts (measured). */
static void camera_bend(struct camera *camera)
{
    enum camera_kind kind = camera->kind;
    bool sphere = kind == CAMERA_SPHERICAL;
    bool wide = kind == CAMERA_ULTRA_WIDE_ANGLE;
    double angle = camera->angle > 0 ? camera->angle : sphere ? 360 : 90;
    double up =
        sphere ? (camera->angle_up > 0 ? camera->angle_up : angle / 2) : angle;
    if (wide)
        up *= vec3_length(camera->up) / vec3_length(camera->right);
    camera->turn = angle * (M_PI / 180);
    camera->turn_up = up * (M_PI / 180);
    if (kind == CAMERA_PANORAMIC)
        return;
    if (kind == CAMERA_FISHEYE || kind == CAMERA_OMNIMAX) {
        camera->direction = vec3_normalise(camera->direction);
        return;
    }
    camera->direction = vec3_normalise(camera->direction);
    if (kind != CAMERA_CYLINDER_2 && kind != CAMERA_CYLINDER_4)
        camera->right = vec3_normalise(camera->right);
    if (kind != CAMERA_CYLINDER_1 && kind != CAMERA_CYLINDER_3)
        camera->up = vec3_normalise(camera->up);
}

const char *camera_finish(struct camera *camera)
{
    const char *problem = camera_check(camera);
    if (problem)
        return problem;
    camera->focus =
        vec3_length(vec3_sub(camera->focal_point, camera->location));
    if (camera->kind == CAMERA_ORTHOGRAPHIC) {
        camera_size(camera);
    } else if (camera_is_bent(camera)) {
        camera_bend(camera);
    } else if (camera->angle > 0) {
        double tangent = tan(camera->angle * (M_PI / 180) / 2);
        double length = vec3_length(camera->right) / (2 * tangent);
        vec3 unit = vec3_normalise(camera->direction);
        camera->direction = vec3_scale(unit, length);
    }
    if (camera->has_look_at)
        camera_aim(camera);
    return NULL;
}

void camera_move(struct camera *camera, const affine *transform)
{
    camera->location = affine_point(transform, camera->location);
    camera->look_at = affine_point(transform, camera->look_at);
    camera->direction = affine_direction(transform, camera->direction);
    camera->right = affine_direction(transform, camera->right);
    camera->up = affine_direction(transform, camera->up);
    camera->sky = affine_direction(transform, camera->sky);
}

/* right, up and direction times these. */
static vec3 camera_sum(const struct camera *camera, double right, double up,
                       double direction)
{
    vec3 sum = vec3_scale(camera->right, right);
    sum = vec3_along(sum, camera->up, up);
    return vec3_along(sum, camera->direction, direction);
}

/* From the middle of a fisheye's disc, whose edge is at 1. */
static double camera_disc(const struct camera *camera, double x, double y)
{
    return 2 *
           hypot(x * vec3_length(camera->right), y * vec3_length(camera->up));
}

/* The angle from the direction at r of a dome's disc, radians: a quarter turn
 * at its edge, 1. */
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

static vec3 camera_omnimax(const struct camera *camera, double x, double y)
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    double r = hypot(disc[0], disc[1]), angle = omnimax_angle(r);
    double side = r > 0 ? sin(angle) / r : 0;
    vec3 sum = vec3_scale(vec3_normalise(camera->right), side * disc[0]);
    sum = vec3_along(sum, vec3_normalise(camera->up), side * disc[1]);
    return vec3_along(sum, camera->direction, cos(angle));
}

static bool omnimax_sees(const struct camera *camera, double x, double y)
{
    double disc[2];
    omnimax_place(camera, x, y, disc);
    double r = hypot(disc[0], disc[1]), angle = omnimax_angle(r);
    return r <= 1 && disc[1] * sin(angle) >= -r * cos(angle);
}

bool camera_sees(const struct camera *camera, double x, double y)
{
    if (camera->kind == CAMERA_OMNIMAX)
        return omnimax_sees(camera, x - 0.5, 0.5 - y);
    return camera->kind != CAMERA_FISHEYE ||
           camera_disc(camera, x - 0.5, 0.5 - y) <= 1;
}

/* All places as far from the middle are as far from the direction. */
static vec3 camera_fisheye(const struct camera *camera, double x, double y)
{
    double r = camera_disc(camera, x, y), angle = r * camera->turn / 2;
    double side = r > 0 ? 2 * sin(angle) / r : 0;
    return camera_sum(camera, side * x, side * y, cos(angle));
}

/* x and y from the middle of the picture, to the right and up (measured, save
 * that a camera which is scaled afterwards was not). */
static struct ray camera_bent_ray(const struct camera *camera, double x,
                                  double y)
{
    double a = x * camera->turn, b = y * camera->turn_up;
    struct ray ray = { camera->location, camera->direction };
    switch (camera->kind) {
    case CAMERA_ULTRA_WIDE_ANGLE:
        ray.direction = camera_sum(camera, sin(a), sin(b), cos(a) * cos(b));
        break;
    case CAMERA_FISHEYE:
        ray.direction = camera_fisheye(camera, x, y);
        break;
    case CAMERA_OMNIMAX:
        ray.direction = camera_omnimax(camera, x, y);
        break;
    case CAMERA_PANORAMIC:
        ray.direction =
            camera_sum(camera, sin(M_PI * x), tan(M_PI * y), cos(M_PI * x));
        break;
    case CAMERA_SPHERICAL:
        ray.direction =
            camera_sum(camera, sin(a) * cos(b), sin(b), cos(a) * cos(b));
        break;
    case CAMERA_CYLINDER_1:
        ray.direction = camera_sum(camera, sin(a), y, cos(a));
        break;
    case CAMERA_CYLINDER_2:
        ray.direction = camera_sum(camera, x, sin(b), cos(b));
        break;
    case CAMERA_CYLINDER_3:
        ray.origin = vec3_along(ray.origin, camera->up, y);
        ray.direction = camera_sum(camera, sin(a), 0, cos(a));
        break;
    default:
        ray.origin = vec3_along(ray.origin, camera->right, x);
        ray.direction = camera_sum(camera, 0, sin(b), cos(b));
        break;
    }
    ray.direction = vec3_normalise(ray.direction);
    return ray;
}

struct ray camera_ray(const struct camera *camera, double x, double y)
{
    if (camera_is_bent(camera))
        return camera_bent_ray(camera, x - 0.5, 0.5 - y);
    vec3 offset = vec3_scale(camera->right, x - 0.5);
    offset = vec3_along(offset, camera->up, 0.5 - y);
    struct ray ray = { camera->location, camera->direction };
    if (camera->kind == CAMERA_ORTHOGRAPHIC)
        ray.origin = vec3_add(ray.origin, offset);
    else
        ray.direction = vec3_add(ray.direction, offset);
    ray.direction = vec3_normalise(ray.direction);
    return ray;
}

/* What is in the plane at the distance of the focal point, straight ahead,
 * stays where it is. */
struct ray camera_lens_ray(const struct camera *camera, double x, double y,
                           const double lens[2])
{
    struct ray ray = camera_ray(camera, x, y);
    double ahead = vec3_dot(ray.direction, vec3_normalise(camera->direction));
    vec3 sharp = vec3_along(ray.origin, ray.direction, camera->focus / ahead);
    ray.origin = vec3_along(ray.origin, vec3_normalise(camera->right),
                            lens[0] * camera->aperture);
    ray.origin = vec3_along(ray.origin, vec3_normalise(camera->up),
                            lens[1] * camera->aperture);
    ray.direction = vec3_normalise(vec3_sub(sharp, ray.origin));
    return ray;
}

vec3 camera_view(const struct camera *camera, vec3 point)
{
    vec3 offset = vec3_sub(point, camera->location);
    vec3 across = vec3_cross(camera->right, camera->up);
    double volume = vec3_dot(across, camera->direction);
    vec3 sideways = vec3_cross(camera->up, camera->direction);
    vec3 upwards = vec3_cross(camera->direction, camera->right);
    vec3 view = { vec3_dot(offset, sideways), vec3_dot(offset, upwards),
                  vec3_dot(offset, across) };
    return vec3_scale(view, 1 / volume);
}

void camera_place(const struct camera *camera, vec3 view, double *x, double *y)
{
    double scale = camera->kind == CAMERA_PERSPECTIVE ? 1 / view.z : 1;
    *x = 0.5 + view.x * scale;
    *y = 0.5 - view.y * scale;
}
