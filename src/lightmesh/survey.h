/* What indirect light would do to a picture, by a few gather rays from what its
 * camera sees: how many rays it is worth, and whether there is any. */
#ifndef LIGHTMESH_SURVEY_H
#define LIGHTMESH_SURVEY_H

#include "lightmesh/bright.h"
#include "lightmesh/gather.h"
#include "lightmesh/indirect_light.h"
#include "lightmesh/virtual_lights.h"

enum { SURVEY_HITS = 128, SURVEY_SIGHTS = 256 };

struct survey {
    double open;  /* share of gather rays that leave the scene, or end where it
                   * glows: there is no bounce after them */
    bool stays;   /* light goes on from what one of them met, or one that was
                   * sent from a far side */
    bool closed;  /* most light stays, or what is half open is mostly lit by
                   * its own surfaces: the skeleton of the void ends its
                   * bounces, and virtual lights bring what lamps light */
    double worth; /* what they change of what the picture shows: mean, relative
                   */
    double bounced; /* the same but for what is picked */
    double sent;    /* rays that one of them takes, with those to lamps and
                     * onward from what it meets: mean; 0: nobody looked */
    double rough;   /* by how much one of them differs from another, some being
                     * aimed at what is bright: root mean square, relative to what
                     * the picture shows */
    double picked;  /* the same of what one virtual light brings that a place
                     * picks, */
    double glows;   /* and of one place of what glows */
    struct bright lit; /* places whose light virtual lights bring; 0: none */
    struct virtual_lights *lights; /* these, the caller's; NULL: none */
    struct bright bright;          /* where most of the rest comes from */
    int hits; /* some of what they met, from all over the picture */
    struct bright_hit hit[SURVEY_HITS];
    struct indirect_share around; /* what surfaces give each other, mean */
    int sights;                   /* places that the camera sees */
    struct survey_sight {
        vec3 place;
        double half; /* units: nearer than that half of its rays met something;
                      * HUGE_VAL: fewer did at all */
    } sight[SURVEY_SIGHTS];
};

/* What to reckon with where nobody looks: all matters. */
struct survey survey_none(void);

/* How to look. */
struct survey_options {
    int rays;  /* of each place, at least 4 */
    int times; /* as many virtual lights as a picture needs; 0: none */
    const struct survey *known; /* that is as closed unless this one is plainly
                                 * not, and whose bright and lit places are
                                 * taken if they serve nearly as well as others
                                 * that are found; NULL: none is known */
};

/* `gather` has no mesh. */
struct survey survey_of(const struct gather *gather, const struct scene *scene,
                        struct worker *worker,
                        const struct survey_options *options);

/* Takes a line: what, how much, and its unit or "". */
typedef void survey_row(void *context, const char *what, double amount,
                        const char *unit);
void survey_tell(const struct survey *survey, survey_row *row, void *context);

#endif
