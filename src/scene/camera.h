/* The camera: vectors final, all of angle, look_at and sky worked in
 * (section 5.8 of tests/povray.md). */
#ifndef SCENE_CAMERA_H
#define SCENE_CAMERA_H

#include "base/affine.h"
#include "scene/ray.h"

enum camera_kind {
    CAMERA_PERSPECTIVE,
    CAMERA_ORTHOGRAPHIC,
    CAMERA_ULTRA_WIDE_ANGLE,
    CAMERA_PANORAMIC,
    CAMERA_SPHERICAL,
    CAMERA_CYLINDER_1, /* upright, seen from its middle */
    CAMERA_CYLINDER_2, /* lying */
    CAMERA_CYLINDER_3, /* upright, each line seen from its own height */
    CAMERA_CYLINDER_4, /* lying, each column from its own place */
    CAMERA_FISHEYE,    /* a disc; the rest of the picture is black */
    CAMERA_OMNIMAX,    /* a disc, cut off below: a dome's film */
};

struct camera {
    enum camera_kind kind;
    vec3 location, direction, right, up, sky;
    bool has_size;   /* right or up was given: an orthographic camera's size */
    double angle;    /* degrees, 0: none */
    bool angle_said; /* also one of 0, by which an orthographic camera's size is
                      * that of a perspective one at look_at (measured) */
    double angle_up; /* of a spherical camera */
    double turn, turn_up; /* radians across and up the picture of those that
                           * bend it; their vectors that turn are unit */
    vec3 look_at;
    bool has_look_at;
    /* Focal blur: how wide the lens is, 0 for none; the point whose distance is
     * that of the plane where all is sharp; rays of a place, at least and at
     * most; and when fewer are enough. */
    double aperture;
    vec3 focal_point;
    double focus;           /* that distance */
    double blur_samples[2]; /* whole numbers */
    double confidence, variance;
};

/* POV-Ray's: at the origin, looking along z, right 1.33 x, look_at z. */
struct camera camera_default(void);

/* Whether straight lines are bent in its pictures: places in them can't be
 * found by camera_place. */
static inline bool camera_is_bent(const struct camera *camera)
{
    return camera->kind > CAMERA_ORTHOGRAPHIC;
}

/* Whether its lens blurs what is out of focus. */
static inline bool camera_blurs(const struct camera *camera)
{
    return camera->aperture != 0 && camera->blur_samples[1] >= 1;
}

/* Works `look_at` and `angle` into direction, right and up, once everything in
 * the block has been read; then come the block's transformations, wherever
 * they were written. Returns NULL or what is wrong ("look_at is the same point
 * as location"). */
const char *camera_finish(struct camera *camera);

/* The camera moved by `transform`: all its vectors. */
void camera_move(struct camera *camera, const affine *transform);

/* Whether there is a picture at (x, y), both in [0,1] from the top left: round
 * the disc of a fisheye or a dome there is none, and it is black. */
bool camera_sees(const struct camera *camera, double x, double y);

/* The ray through the picture at (x, y). The direction is unit. */
struct ray camera_ray(const struct camera *camera, double x, double y);

/* The same through another point of the lens, from its middle along right and
 * up, for an aperture of 1 (scene/lens.h). */
struct ray camera_lens_ray(const struct camera *camera, double x, double y,
                           const double lens[2]);

/* A point from the camera: so many rights, ups and directions away from its
 * location. Not finite if these lie in a plane. */
vec3 camera_view(const struct camera *camera, vec3 point);

/* Where in the picture that is, (x, y) as of camera_ray; of a perspective
 * camera view.z must be above 0; not of one that bends lines. */
void camera_place(const struct camera *camera, vec3 view, double *x, double *y);

#endif
