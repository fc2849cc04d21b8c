/* Orbit, pan, dolly, walk: see fly.h. */
#include "view/fly.h"

#include <stdbool.h>
#include <string.h>

/* Of the angle between looking and the sky, degrees: nearer it doesn't tilt. */
static const double pole = 2;

static void fly_rotate(struct camera *camera, vec3 pivot, vec3 axis,
                       double degrees)
{
    vec3 sky = camera->sky;
    affine back = affine_translation(vec3_negate(pivot));
    affine turn = affine_axis_rotation(axis, degrees);
    affine all =
        affine_compose(affine_translation(pivot), affine_compose(turn, back));
    camera_move(camera, &all);
    camera->sky = sky;
}

/* How far it may tilt up: what stays of `up`. */
static double fly_tilt(const struct camera *camera, double up)
{
    vec3 sky = vec3_normalise(camera->sky);
    vec3 ahead = vec3_normalise(camera->direction);
    double cosine = fmax(-1, fmin(1, vec3_dot(sky, ahead)));
    double from = acos(cosine) * (180 / M_PI); /* of the sky */
    double least = fmin(from, pole), most = fmax(from, 180 - pole);
    return from - fmax(least, fmin(most, from - up));
}

/* Which way is right: of a picture that is mirrored, the other. */
static vec3 fly_right(const struct camera *camera)
{
    return vec3_normalise(vec3_cross(vec3_normalise(camera->up),
                                     vec3_normalise(camera->direction)));
}

static void fly_about(struct camera *camera, vec3 pivot, double right,
                      double up)
{
    fly_rotate(camera, pivot, camera->sky, right);
    fly_rotate(camera, pivot, fly_right(camera), -fly_tilt(camera, up));
}

void fly_orbit(struct camera *camera, vec3 pivot, double right, double up)
{
    fly_about(camera, pivot, -right, -up);
}

void fly_turn(struct camera *camera, double right, double up)
{
    fly_about(camera, camera->location, right, up);
}

/* Of the picture at a distance, in units for 1 of the vector. */
static double fly_scale(const struct camera *camera, double distance)
{
    double length = vec3_length(camera->direction);
    return camera->kind->lines == CAMERA_PARALLEL ? 1 : distance / length;
}

void fly_pan(struct camera *camera, double distance, double right, double up)
{
    double scale = fly_scale(camera, distance);
    vec3 to = vec3_along(camera->location, camera->right, right * scale);
    camera->location = vec3_along(to, camera->up, up * scale);
}

void fly_dolly(struct camera *camera, vec3 pivot, double factor)
{
    if (camera->kind->lines == CAMERA_PARALLEL) {
        camera->right = vec3_scale(camera->right, factor);
        camera->up = vec3_scale(camera->up, factor);
        return;
    }
    camera->location = vec3_mix(pivot, camera->location, factor);
    camera->focus *= factor;
}

void fly_walk(struct camera *camera, double ahead, double right)
{
    vec3 to =
        vec3_along(camera->location, vec3_normalise(camera->direction), ahead);
    camera->location = vec3_along(to, vec3_normalise(camera->right), right);
}

static bool fly_is(const struct camera *camera, const char *kind)
{
    return strcmp(camera->kind->name, kind) == 0;
}

static void fly_vector(FILE *out, const char *name, vec3 v)
{
    fprintf(out, "  %s <%.10g, %.10g, %.10g>\n", name, v.x, v.y, v.z);
}

/* What camera_finish has made of angles. */
static void fly_angles(const struct camera *camera, FILE *out)
{
    double across = camera->turn * (180 / M_PI);
    if (fly_is(camera, "spherical"))
        fprintf(out, "  angle %.10g %.10g\n", across,
                camera->turn_up * (180 / M_PI));
    else if (camera->kind->lines == CAMERA_BENT && camera->turn > 0 &&
             !fly_is(camera, "omnimax"))
        fprintf(out, "  angle %.10g\n", across);
}

static void fly_blur(const struct camera *camera, FILE *out)
{
    if (!camera_blurs(camera))
        return;
    vec3 ahead = vec3_normalise(camera->direction);
    fly_vector(out, "focal_point",
               vec3_along(camera->location, ahead, camera->focus));
    fprintf(out,
            "  aperture %.10g blur_samples %.0f, %.0f\n"
            "  confidence %.10g variance %.10g\n",
            camera->aperture, camera->blur_samples[0], camera->blur_samples[1],
            camera->confidence, camera->variance);
}

void fly_print(const struct camera *camera, FILE *out)
{
    vec3 up = camera->up;
    if (fly_is(camera, "ultra_wide_angle")) /* says the angle up */
        up = vec3_scale(up, camera->turn_up / camera->turn);
    fprintf(out, "camera {\n  %s", camera->kind->name);
    if (camera->kind->arguments)
        fprintf(out, " %d", camera->number);
    fputs("\n", out);
    fly_vector(out, "location", camera->location);
    fly_vector(out, "direction", camera->direction);
    fly_vector(out, "right", camera->right);
    fly_vector(out, "up", up);
    fly_angles(camera, out);
    fly_blur(camera, out);
    fputs("}\n", out);
}

bool fly_same(const struct camera *a, const struct camera *b)
{
    const vec3 pairs[][2] = { { a->location, b->location },
                              { a->direction, b->direction },
                              { a->right, b->right },
                              { a->up, b->up } };
    bool same = a->kind == b->kind;
    for (int i = 0; i < 4; i++)
        same = same && vec3_length(vec3_sub(pairs[i][0], pairs[i][1])) == 0;
    return same;
}

bool fly_free(const struct camera *camera)
{
    return camera->kind->lines != CAMERA_SCATTERED;
}
