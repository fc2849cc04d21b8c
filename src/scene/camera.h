/* The camera: vectors final, all of angle, look_at and sky worked in
 * (section 5.8 of tests/povray.md). */
#ifndef SCENE_CAMERA_H
#define SCENE_CAMERA_H

#include "base/affine.h"
#include "base/field.h"
#include "scene/rays.h"

/* How a camera's rays lie. */
enum camera_lines {
    CAMERA_CENTRAL,   /* from one point; straight lines stay straight */
    CAMERA_PARALLEL,  /* side by side; straight lines stay straight */
    CAMERA_BENT,      /* lines are bent */
    CAMERA_SCATTERED, /* from anywhere to anywhere */
};

struct camera;

/* Places of the picture side by side. */
struct camera_places {
    LANE_LINES double x[RAY_LANES], y[RAY_LANES];
};

/* An angle's. */
struct camera_turn {
    double sine, cosine;
};

/* One kind of camera: a file in camera/ and a row in camera/list.h. */
struct camera_kind {
    const char *name; /* the keyword */
    const char *help;
    /* After the keyword; of struct camera. NULL: nothing. */
    const struct field *arguments;
    enum camera_lines lines;
    /* Once all has been read, before it is turned to look_at; NULL: nothing. */
    void (*finish)(struct camera *camera);
    /* Whether it sees anything at x to the right and y above the middle of the
     * picture, whose sides are 1; NULL: everywhere. */
    bool (*sees)(const struct camera *camera, double x, double y);
    /* Its ray there, of any length; NULL: it is made of angles. */
    struct ray (*ray)(const struct camera *camera, double x, double y);
    /* Of kinds that turn, instead of it: two angles of the place, radians, and
     * the ray there by what these have. */
    void (*angles)(const struct camera *camera, double x, double y,
                   double at[2]);
    struct ray (*turned)(const struct camera *camera, double x, double y,
                         const struct camera_turn turns[2]);
    /* The same at RAY_LANES places, each as `ray` has it to the bit. NULL: one
     * by one. */
    void (*ray_many)(const struct camera *camera,
                     const struct camera_places *places, struct rays *rays);
    /* What the normal's pattern is asked at there; NULL: x and y themselves.
     * Kinds that turn ask it at angles, in radians (measured). */
    void (*bend_at)(const struct camera *camera, double x, double y,
                    double at[2]);
    /* The rays of one pixel, number 0 to camera->rays - 1. False: there is not
     * this one. NULL: there is only `ray`. */
    bool (*pixel_ray)(const struct camera *camera, double x, double y, int i,
                      struct ray *ray);
};

extern const struct camera_kind perspective_camera;

/* The kind of this name, or NULL. */
const struct camera_kind *camera_kind_find(const char *name);

/* Number `index` of the list, or NULL past its end. */
const struct camera_kind *camera_kind_at(size_t index);

struct camera_mesh;
struct normal;

struct camera {
    const struct camera_kind *kind;
    int number;                     /* of a cylinder camera: 1 to 4 */
    int pixels[2];                  /* across and down the picture */
    int rays;                       /* of one pixel, their mean is seen; 1 */
    const struct camera_mesh *mesh; /* of a mesh_camera */
    const struct normal *normal;    /* bends the rays, or NULL */
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
    const struct pigment *bokeh; /* how much light the lens lets through where,
                                  * or NULL: a round one */
};

/* POV-Ray's: at the origin, looking along z, right 1.33 x, look_at z. */
struct camera camera_default(void);

/* Whether straight lines are bent in its pictures: places in them can't be
 * found by camera_place. */
static inline bool camera_is_bent(const struct camera *camera)
{
    return camera->kind->lines > CAMERA_PARALLEL || camera->normal;
}

/* right, up and direction times these. */
static inline vec3 camera_sum(const struct camera *camera, double right,
                              double up, double direction)
{
    vec3 sum = vec3_scale(camera->direction, direction);
    sum = vec3_along(sum, camera->right, right);
    return vec3_along(sum, camera->up, up);
}

/* For kinds that turn: angles are put into turn and turn_up, `usual` if none
 * is said, and the direction is made a unit. */
void camera_turns(struct camera *camera, double usual);

/* The angles of a place, in radians, of kinds that turn evenly. */
void camera_turned(const struct camera *camera, double x, double y,
                   double at[2]);

/* The angle of a place around the middle of a disc, from a quarter turn below
 * to three above. */
double camera_around(double x, double y);

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

/* The same through the first `count` of the places, all of which are there. */
void camera_rays(const struct camera *camera,
                 const struct camera_places *places, unsigned count,
                 struct rays *rays);

/* The ray number `i` of the pixel, from 0 to camera->rays - 1. False: there is
 * none. */
bool camera_pixel_ray(const struct camera *camera, double x, double y, int i,
                      struct ray *ray);

/* The same as camera_ray through another point of the lens, from its middle
 * along right and up, for an aperture of 1 (scene/lens.h). */
struct ray camera_lens_ray(const struct camera *camera, double x, double y,
                           const double lens[2]);

/* The same of the first `count` places and points; there are RAY_LANES. */
void camera_lens_rays(const struct camera *camera,
                      const struct camera_places *places,
                      const struct camera_places *lens, unsigned count,
                      struct rays *rays);

/* A point from the camera: so many rights, ups and directions away from its
 * location. Not finite if these lie in a plane. */
vec3 camera_view(const struct camera *camera, vec3 point);

/* Where in the picture that is, (x, y) as of camera_ray; of a perspective
 * camera view.z must be above 0; not of one that bends lines. */
void camera_place(const struct camera *camera, vec3 view, double *x, double *y);

#endif
