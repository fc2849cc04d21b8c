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

/* A place that the camera sees. */
struct seen {
    vec3 place, side; /* unit, from which it is seen */
    rgb shows;        /* of irradiance, of all that the picture shows there */
};

/* Of all gather rays. */
struct sums {
    const struct gather *gather;
    int sights, each; /* places, and rays of one, */
    int choosing;     /* the first of which find what is bright; the others
                       * judge */
    bool stays;       /* as of a survey */
    double open, ends, worth, bounced, returned, sent;
    rgb light;
    struct bright_hit *hits;
    struct brought *brought;
    struct seen *seen;
};

/* How many there are. */
static inline size_t sums_rays(const struct sums *sums)
{
    return (size_t)sums->sights * (size_t)sums->each;
}

/* The cells that the hits of those which choose are for, as bright_of or
 * lit_cells_of tells. */
typedef struct bright hits_cells(const struct bright_hit *hits, size_t count);
struct bright sums_cells(const struct sums *sums, hits_cells *of);

/* Virtual lights, if they bring much of all light, into survey->lights and
 * survey->lit; what they bring is left out of the sums. Fog would weaken it. */
void sums_light(struct sums *sums, const struct survey_options *options,
                struct worker *worker, struct survey *survey);

/* By how much differs what one ray brings to what glows. */
double sums_glows(const struct sums *sums, struct worker *worker);

#endif
