/* Where a ray crosses an isosurface: see isosurface_search.c. */
#ifndef SCENE_ISOSURFACE_SEARCH_H
#define SCENE_ISOSURFACE_SEARCH_H

#include "scene/isosurface.h"

struct search {
    const struct isosurface *surface;
    const struct ray *ray;
    struct hits *hits;
    double gradient; /* of the function by t, at most */
    double accuracy; /* in t */
    int left;        /* function calls */
    int wanted;      /* crossings, at most: the nearest */
};

/* Adds the crossings between t = a and t = b to the hits; the values there are
 * known. */
void search_crossings(struct search *search, double a, double at_a, double b,
                      double at_b);

#endif
