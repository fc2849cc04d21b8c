/* What is decided for one picture before light meshes are made: who is asked
 * about lamps, where mesh points are, how many rays they send, what memory they
 * may have. Made of what the scene and the options say, of what the camera sees
 * and of tuning.h; nobody else compares lamps with thresholds. `--stats` prints
 * it. */
#ifndef LIGHTMESH_PLAN_H
#define LIGHTMESH_PLAN_H

#include "lightmesh/direct.h"
#include "lightmesh/indirect.h"
#include "lightmesh/mesh_stamp.h"
#include "lightmesh/outlook.h"
#include "lightmesh/survey.h"
#include "scene/scene.h"

/* How lamps are asked. */
enum plan_lamps {
    PLAN_EACH,    /* each by shadow rays: mesh points do not see what falls
                   * between them */
    PLAN_BLENDED, /* each at the mesh points around; of area lights shadow rays,
                   * which make their shadows soft anyway */
    PLAN_SETTLED, /* by shadow rays those on which the mesh points around
                   * differ */
    PLAN_SUMMED,  /* all together at mesh points */
};

struct plan {
    enum plan_lamps lamps;
    bool pixels;    /* the picture's own pixels may be mesh points, ... */
    bool penumbras; /* and know the shares of area lights */
    double finer;   /* than quality 5: a factor */
    struct mesh_frame frame;
    struct direct_options direct;
    struct indirect_options indirect; /* no bounces: there is none */
};

/* What a picture is one of. In a film noise is seen that isn't in a picture by
 * itself; less of it where frames are smoothed by those around (moments.c). */
enum plan_film { PLAN_ALONE, PLAN_FILM, PLAN_SMOOTHED };

/* Where mesh points are. `coarser`: steps to fewer points, which had no room.
 */
struct mesh_frame plan_frame(const struct scene *scene,
                             const struct outlook *outlook,
                             const struct survey *survey, enum plan_film film,
                             int coarser);

/* At which levels a picture asks the points of another's frame (`finest` of
 * struct lattice_view). */
struct plan_levels {
    double direct, indirect;
};

/* Those at which they are about as near to each other as the picture wants.
 * Small differences are none, lest what a still surface shows changes when the
 * camera moves. */
struct plan_levels plan_levels(const struct mesh_frame *made,
                               const struct mesh_frame *now);

/* Makes the frame that of the root of its animation, but for its light: what
 * moves must not change where mesh points are, nor how many rays they send.
 * Into *levels those at which the picture can afford them. Returns false if
 * they differ too much, or are lit in other ways. */
bool plan_follow(struct mesh_frame *frame, const struct mesh_frame *root,
                 struct plan_levels *levels);

/* Where the indirect mesh would have so many points for a picture of so many
 * pixels: makes fewer of them, of fewer rays, if these are more than indirect
 * light is worth; in a `film` noise is worth more. Returns whether it did. */
bool plan_afford(struct mesh_frame *frame, const struct scene *scene,
                 const struct survey *survey, double points, double pixels,
                 bool film);

/* What of `shadows` counts for what mesh points hold: of few lamps, and where
 * none is asked for, the same. */
enum mesh_shadows plan_held(const struct light_mesh_settings *said,
                            size_t lamps);

/* The rest of it: `frame` is this picture's, or of the mesh it begins with;
 * `interpolation` the one that is said, or the default; `close` ends the
 * bounces, with its context, or NULL. The scene must outlive it. */
struct plan plan_new(const struct scene *scene, const struct lamps *lamps,
                     const struct mesh_frame *frame,
                     const struct interpolation *interpolation,
                     gather_close *close, const void *close_context);

/* Takes a line: what, how much, and its unit or ""; NAN: the unit says all. */
typedef void plan_row(void *context, const char *what, double amount,
                      const char *unit);
void plan_tell(const struct plan *plan, plan_row *row, void *context);

#endif
