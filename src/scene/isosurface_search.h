/* Where rays cross isosurfaces: see isosurface_search.c. */
#ifndef SCENE_ISOSURFACE_SEARCH_H
#define SCENE_ISOSURFACE_SEARCH_H

#include "scene/bracket.h"
#include "scene/isosurface.h"
#include "scene/spots.h"

enum {
    SEARCH_DEPTH = 64, /* as often is the way of a ray halved */
    SEARCH_AHEAD = OCTET - 1,
};

/* A place on a ray and the value there. */
struct search_place {
    double t, value;
};

/* On its way along a ray. */
struct search {
    struct ray ray;
    double gradient;          /* of the function by t, at most */
    double accuracy;          /* in t */
    double spread;            /* how much more by t, if not 0 */
    double asked;             /* where a value is wanted next */
    struct search_place here; /* nothing before it is to be looked for */
    int depth;                /* stretches from here on: see ends */
    int left;                 /* function calls */
    int found, wanted;        /* crossings; at most: the nearest */
    bool coarse;              /* crossings are where stretches as short as the
                               * accuracy end, as POV-Ray has it (measured) */
    bool any;                 /* whether there is a crossing will do: it is
                               * anywhere in its stretch */
    int round;                /* of the crossing in the first, if not 0 */
    int ahead;                /* values that were worked out with others */
    struct search_place known[SEARCH_AHEAD]; /* these values */
    struct search_place ends[SEARCH_DEPTH];  /* the nearest last */
    struct bracket bracket;                  /* if there is a round */
    double *crossings;                       /* t */
};

/* From a to b, whose values are known; `crossings` has room for as many as are
 * wanted and belongs to the caller. */
void search_set_out(struct search *search, const struct isosurface *surface,
                    double *crossings, int wanted);
void search_stretch(struct search *search, struct search_place a,
                    struct search_place b);

/* Ends all of these searches, which have set out. */
void search_run(const struct isosurface *surface, struct search *const *all,
                int count);

#endif
