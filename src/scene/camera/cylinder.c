/* cylinder 1 to 4: the picture is rolled. Across or up it the length of the
 * vector that isn't rolled counts (measured). */
#include "scene/camera.h"

static const struct field cylinder_arguments[] = {
    { "kind", FIELD_INTEGER, offsetof(struct camera, number), 1, 4,
      "1 upright, seen from its middle; 2 lying; 3, 4 the same, each line seen "
      "from its own place" },
    { NULL },
};

static bool cylinder_stands(const struct camera *camera)
{
    return camera->number == 1 || camera->number == 3;
}

static void cylinder_finish(struct camera *camera)
{
    camera_turns(camera, 90);
    if (cylinder_stands(camera))
        camera->right = vec3_normalise(camera->right);
    else
        camera->up = vec3_normalise(camera->up);
}

static struct ray cylinder_turned(const struct camera *camera, double x,
                                  double y, const struct camera_turn turns[2])
{
    struct ray ray = { .origin = camera->location };
    bool along = camera->number > 2;
    if (cylinder_stands(camera)) {
        if (along)
            ray.origin = vec3_along(ray.origin, camera->up, y);
        ray.direction =
            camera_sum(camera, turns[0].sine, along ? 0 : y, turns[0].cosine);
    } else {
        if (along)
            ray.origin = vec3_along(ray.origin, camera->right, x);
        ray.direction =
            camera_sum(camera, along ? 0 : x, turns[1].sine, turns[1].cosine);
    }
    return ray;
}

static void cylinder_bend_at(const struct camera *camera, double x, double y,
                             double at[2])
{
    camera_turned(camera, x, y, at);
    if (cylinder_stands(camera))
        at[1] = y * vec3_length(camera->up);
    else
        at[0] = x * vec3_length(camera->right);
}

const struct camera_kind cylinder_camera = {
    .name = "cylinder",
    .help = "rolled, 1 and 3 upright, 2 and 4 lying",
    .arguments = cylinder_arguments,
    .lines = CAMERA_BENT,
    .finish = cylinder_finish,
    .angles = camera_turned,
    .turned = cylinder_turned,
    .bend_at = cylinder_bend_at,
};
