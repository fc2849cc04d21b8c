/* Who knows the light of lamps here: a ladder, cheapest first. A receiver asks
 * one after the other; whoever can't answer passes on to the next. Each is one
 * file of knower/ and one row of its list.h. Which of them know anything of a
 * picture, and whether lamps are asked one by one or all together, is the
 * plan's (plan.h). */
#ifndef LIGHTMESH_KNOWER_H
#define LIGHTMESH_KNOWER_H

#include "lightmesh/incident.h"
#include "lightmesh/penumbra.h"
#include "lightmesh/pixel_mesh.h"
#include "lightmesh/plan.h"

/* What there is to ask in a picture. */
struct knowers {
    const struct plan *plan;
    const struct lamps *lamps;
    const struct direct_mesh *direct;
    const struct pixel_mesh *pixels;   /* or NULL */
    const struct penumbras *penumbras; /* or NULL */
};

/* A receiver that asks, and what its knowers noted for the next lamp. */
struct asking {
    const struct knowers *knowers;
    struct worker *worker;
    struct receiver receiver;       /* on the viewer's side */
    const struct interiors *inside; /* bodies that the viewer's ray is in */
    int answered;        /* number of the knower that told the last answer */
    struct asking_side { /* of space: before the surface, and behind it */
        bool known;
        struct mesh_blend blend;
        struct direct_verdict verdict;
    } side[2];
};

/* A picture, for the cost of asking. */
struct knower_job {
    double pixels; /* of the whole picture */
    double lamps;
    double triangles; /* that throw shadows */
    double points;    /* that look at all of these */
    double doubtful;  /* of them, that a ray must decide */
    double finer;     /* than quality 5, a factor */
};

struct knower {
    const char *name;
    const char *help;
    /* Seconds that it takes for all lamps and pixels, as measured once; NULL:
     * nobody compares it. */
    double (*cost)(const struct knower_job *job);
    /* The share of a lamp's light that gets to the receiver, or false: it
     * doesn't know. NULL: it knows of no single lamp. */
    bool (*one_lamp)(struct asking *asking, const struct lamp *lamp,
                     const struct lamp_view *view, rgb *share);
    /* The light of all lamps on the receiver's side, or false. NULL: it knows
     * of single lamps alone. */
    bool (*all_lamps)(struct asking *asking, struct incident *incident);
};

/* By number, in the order of the ladder; NULL past the end. */
const struct knower *knower_at(size_t index);

/* Nobody has been asked yet. `asking` is large, and only its head is set. */
void asking_start(struct asking *asking, const struct knowers *knowers,
                  struct worker *worker, const struct receiver *receiver,
                  const struct interiors *inside);

/* The first answer on the ladder. Of one lamp there always is one; so there is
 * of all if the plan sums lamps. */
rgb asking_one_lamp(struct asking *asking, const struct lamp *lamp,
                    const struct lamp_view *view);
void asking_all_lamps(struct asking *asking, struct incident *incident);

/* Whether nothing of the lamp can get to the front, and so nobody need be asked
 * how much: known at no cost beside what the first such question took. */
bool asking_rules_out(struct asking *asking, const struct lamp *lamp);

/* Whether lamps that are points look at the picture's pixels at less cost than
 * what is asked otherwise. */
bool knower_pixels_pay(const struct plan *plan, const struct knower_job *job);

#endif
