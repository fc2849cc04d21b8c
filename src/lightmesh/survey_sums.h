/* What a survey has found (survey.c), and which of it virtual lights are to
 * bring (survey_lit.c). */
#ifndef LIGHTMESH_SURVEY_SUMS_H
#define LIGHTMESH_SURVEY_SUMS_H

#include "lightmesh/survey.h"

/* What a gather ray brings, of what the picture shows there. */
struct brought {
    double light, even; /* by so many rays per solid angle */
    double lamps;       /* of the light, what hit.lamps is */
};

/* Of all gather rays. */
struct sums {
    const struct gather *gather;
    int sights, each; /* places, and rays of one, */
    int choosing;     /* the first of which find what is bright; the others
                       * judge */
    double open, ends, worth, returned;
    rgb light;
    struct bright_hit *hits;
    struct brought *brought;
};

/* The places that those which choose found to be bright. */
struct bright sums_bright(const struct sums *sums);

/* Bright places that are lit by lamps, if much of all light is: those that are
 * known if that is nearly as much. What virtual lights bring of it is left out
 * of the sums. Fog would weaken it. */
struct bright sums_lit(struct sums *sums, const struct bright *known,
                       struct worker *worker);

#endif
