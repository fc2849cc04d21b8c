/* Cameras, as POV-Ray's (section 5.8 of tests/povray.md; the size of an
 * orthographic picture was measured with some twenty cameras). */
#include "scene/camera.h"

#include <stddef.h>

#include "base/listing.h"
#include "base/octet_math.h"
#include "scene/material.h"
#include "scene/spots.h"

#define X(name) extern const struct camera_kind name##_camera;
#include "scene/camera/list.h"
#undef X

static const struct camera_kind *const kinds[] = {
#define X(name) &name##_camera,
#include "scene/camera/list.h"
#undef X
};

LISTING(camera_kind, camera_kind, kinds);

struct camera camera_default(void)
{
    return (struct camera){
        .kind = &perspective_camera,
        .rays = 1,
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
    if (camera->kind->lines <= CAMERA_PARALLEL && camera->angle >= 180)
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
    vec3 right = vec3_cross(camera->sky, aim);
    bool lost = !(vec3_length(right) > 1e-9 * vec3_length(camera->sky));
    if (lost)
        right = camera->right;
    right = vec3_normalise(right);
    vec3 up = vec3_cross(aim, right);
    if (lost)
        up = vec3_normalise(up);
    if (mirrored)
        right = vec3_negate(right);
    camera->direction = vec3_scale(aim, vec3_length(camera->direction));
    camera->right = vec3_scale(right, vec3_length(camera->right));
    camera->up = vec3_scale(up, vec3_length(camera->up));
}

void camera_turns(struct camera *camera, double usual)
{
    double angle = camera->angle > 0 ? camera->angle : usual;
    camera->turn = camera->turn_up = angle * (M_PI / 180);
    camera->direction = vec3_normalise(camera->direction);
}

const char *camera_finish(struct camera *camera)
{
    const char *problem = camera_check(camera);
    if (problem)
        return problem;
    camera->focus =
        vec3_length(vec3_sub(camera->focal_point, camera->location));
    if (camera->kind->finish)
        camera->kind->finish(camera);
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

void camera_turned(const struct camera *camera, double x, double y,
                   double at[2])
{
    at[0] = x * camera->turn;
    at[1] = y * camera->turn_up;
}

double camera_around(double x, double y)
{
    double angle = atan2(y, x);
    return angle < -M_PI / 2 ? angle + 2 * M_PI : angle;
}

/* How far a place is above the middle. Rows are counted from below, and the
 * middles of pixels are whole halves of them: so the last bit of rays is
 * POV-Ray's (measured), which decides the colour where surfaces coincide. */
static inline double camera_above(const struct camera *camera, double y)
{
    const double rounds = 0x1.8p52, near = 1e-9; /* what is added rounds off */
    double height = camera->pixels[1], halves = 2 * height * y;
    double whole = halves + rounds - rounds;
    double row = 0.5 * (fabs(halves - whole) < near ? whole : halves);
    return height > 0 ? (height - row) / height - 0.5 : 0.5 - y;
}

bool camera_sees(const struct camera *camera, double x, double y)
{
    return !camera->kind->sees ||
           camera->kind->sees(camera, x - 0.5, camera_above(camera, y));
}

/* Where its normal is asked, x and y from the middle of the picture. */
static vec3 camera_bend_at(const struct camera *camera, double x, double y)
{
    double at[2] = { x, y };
    if (camera->kind->bend_at)
        camera->kind->bend_at(camera, x, y, at);
    return vec3_make(at[0], at[1], 0);
}

/* The normal bends the ray as it bends a surface's at the place in the picture,
 * whose sides are 1 and whose middle is the origin (measured). */
static vec3 camera_bent(const struct camera *camera, double x, double y,
                        vec3 direction)
{
    return vec3_normalise(normal_perturbed(
        camera->normal,
        camera_bend_at(camera, x - 0.5, camera_above(camera, y)), direction, 0,
        NULL));
}

static inline struct ray camera_finished(const struct camera *camera, double x,
                                         double y, struct ray ray)
{
    ray.direction = vec3_normalise(ray.direction);
    if (camera->normal)
        ray.direction = camera_bent(camera, x, y, ray.direction);
    return ray;
}

/* From the middle of the picture. */
static struct ray kind_ray(const struct camera *camera, double x, double y)
{
    const struct camera_kind *kind = camera->kind;
    struct camera_turn turns[2];
    double at[2];
    if (kind->ray)
        return kind->ray(camera, x, y);
    kind->angles(camera, x, y, at);
    for (int i = 0; i < 2; i++)
        turns[i] = (struct camera_turn){ lone_sin(at[i]), lone_cos(at[i]) };
    return kind->turned(camera, x, y, turns);
}

struct ray camera_ray(const struct camera *camera, double x, double y)
{
    return camera_finished(camera, x, y,
                           kind_ray(camera, x - 0.5, camera_above(camera, y)));
}

/* From the middle of the picture, whose y is upwards. */
CLONES static void places_from_middle(const struct camera *camera,
                                      const struct camera_places *restrict at,
                                      struct camera_places *restrict out)
{
    const struct camera from = *camera;
    for (int i = 0; i < RAY_LANES; i++) {
        out->x[i] = at->x[i] - 0.5;
        out->y[i] = camera_above(&from, at->y[i]);
    }
}

CLONES static void directions_unit(struct rays *rays)
{
    double(*restrict to)[RAY_LANES] = rays->direction;
    for (unsigned i = 0; i < RAY_LANES; i++)
        lane_put(to, i, vec3_normalise(lane_get(to, i)));
}

/* camera_bent of them; the places are from the middle of the picture. */
static void rays_bent(const struct camera *camera,
                      const struct camera_places *places, unsigned count,
                      struct rays *rays)
{
    struct spots points = { .count = 0 }, directions = { .count = 0 }, bent;
    _Static_assert((int)RAY_LANES <= (int)SPOTS_MAX, "a packet");
    for (unsigned i = 0; i < count; i++) {
        spots_add(&points, camera_bend_at(camera, places->x[i], places->y[i]));
        spots_add(&directions, rays_direction(rays, (int)i));
    }
    normals_perturbed(camera->normal, &points, &directions, NULL, &bent);
    for (unsigned i = 0; i < count; i++)
        rays_set(rays, (int)i, rays_origin(rays, (int)i),
                 vec3_normalise(spots_at(&bent, (int)i)));
}

/* The rays of OCTET places from number `first` on, of a kind that turns. */
static void octet_turned(const struct camera *camera,
                         const struct camera_places *at, unsigned first,
                         struct rays *rays)
{
    octet sine[2], cosine[2];
    for (unsigned i = 0; i < OCTET; i++) {
        double angles[2];
        camera->kind->angles(camera, at->x[first + i], at->y[first + i],
                             angles);
        sine[0][i] = angles[0];
        sine[1][i] = angles[1];
    }
    for (int k = 0; k < 2; k++) {
        cosine[k] = sine[k];
        octet_sin(&sine[k]);
        octet_cos(&cosine[k]);
    }
    for (unsigned i = 0; i < OCTET; i++) {
        const struct camera_turn turns[2] = { { sine[0][i], cosine[0][i] },
                                              { sine[1][i], cosine[1][i] } };
        struct ray ray = camera->kind->turned(camera, at->x[first + i],
                                              at->y[first + i], turns);
        rays_set(rays, (int)(first + i), ray.origin, ray.direction);
    }
}

void camera_rays(const struct camera *camera,
                 const struct camera_places *places, unsigned count,
                 struct rays *rays)
{
    struct camera_places at;
    struct ray ray = { { 0, 0, 0 }, { 0, 0, 0 } };
    places_from_middle(camera, places, &at);
    if (camera->kind->ray_many)
        camera->kind->ray_many(camera, &at, rays);
    else if (!camera->kind->ray)
        for (unsigned i = 0; i < count; i += OCTET)
            octet_turned(camera, &at, i, rays);
    else
        for (unsigned i = 0; i < RAY_LANES; i++) {
            if (i < count)
                ray = camera->kind->ray(camera, at.x[i], at.y[i]);
            rays_set(rays, (int)i, ray.origin, ray.direction);
        }
    directions_unit(rays);
    if (camera->normal)
        rays_bent(camera, &at, count, rays);
}

bool camera_pixel_ray(const struct camera *camera, double x, double y, int i,
                      struct ray *ray)
{
    if (!camera->kind->pixel_ray) {
        *ray = camera_ray(camera, x, y);
        return i == 0 && camera_sees(camera, x, y);
    }
    if (!camera->kind->pixel_ray(camera, x - 0.5, camera_above(camera, y), i,
                                 ray))
        return false;
    *ray = camera_finished(camera, x, y, *ray);
    return true;
}

/* The camera's axes, unit. */
struct lens_axes {
    vec3 ahead, right, up;
};

static struct lens_axes lens_axes_of(const struct camera *camera)
{
    return (struct lens_axes){ vec3_normalise(camera->direction),
                               vec3_normalise(camera->right),
                               vec3_normalise(camera->up) };
}

/* What is in the plane at the distance of the focal point, straight ahead,
 * stays where it is. */
static inline struct ray ray_of_lens(const struct camera *camera,
                                     const struct lens_axes *axes,
                                     struct ray ray, double across,
                                     double above)
{
    double ahead = vec3_dot(ray.direction, axes->ahead);
    vec3 sharp = vec3_along(ray.origin, ray.direction, camera->focus / ahead);
    vec3 from = vec3_along(ray.origin, axes->right, across * camera->aperture);
    ray.origin = vec3_along(from, axes->up, above * camera->aperture);
    ray.direction = vec3_normalise(vec3_sub(sharp, ray.origin));
    return ray;
}

struct ray camera_lens_ray(const struct camera *camera, double x, double y,
                           const double lens[2])
{
    struct lens_axes axes = lens_axes_of(camera);
    return ray_of_lens(camera, &axes, camera_ray(camera, x, y), lens[0],
                       lens[1]);
}

CLONES static void rays_of_lens(const struct camera *camera,
                                const struct lens_axes *axes,
                                const struct camera_places *restrict lens,
                                struct rays *restrict rays)
{
    const struct camera from = *camera;
    const struct lens_axes along = *axes;
    for (unsigned i = 0; i < RAY_LANES; i++) {
        struct ray ray = { lane_get(rays->origin, i),
                           lane_get(rays->direction, i) };
        ray = ray_of_lens(&from, &along, ray, lens->x[i], lens->y[i]);
        lane_put(rays->origin, i, ray.origin);
        lane_put(rays->direction, i, ray.direction);
    }
}

void camera_lens_rays(const struct camera *camera,
                      const struct camera_places *places,
                      const struct camera_places *lens, unsigned count,
                      struct rays *rays)
{
    struct lens_axes axes = lens_axes_of(camera);
    camera_rays(camera, places, count, rays);
    rays_of_lens(camera, &axes, lens, rays);
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
    double scale = camera->kind->lines == CAMERA_CENTRAL ? 1 / view.z : 1;
    *x = 0.5 + view.x * scale;
    *y = 0.5 - view.y * scale;
}
