/* Shapes that a ray may cross any number of times tell its crossings one after
 * the other: what those ask who want one or all of them. */
#ifndef SCENE_CROSSINGS_H
#define SCENE_CROSSINGS_H

#include "scene/ray.h"

/* As primitive.crossings. */
typedef void crossings_function(const void *shape, const struct ray *ray,
                                double tmin, double tmax, hit_visit *visit,
                                void *context);

struct crossings_nearest {
    struct hit *hit;
    bool found;
};

static inline bool crossings_take(void *context, const struct hit *hit)
{
    struct crossings_nearest *nearest = context;
    *nearest->hit = *hit;
    return nearest->found = true;
}

/* As primitive.first. */
static inline bool crossings_first(crossings_function *crossings,
                                   const void *shape, const struct ray *ray,
                                   double tmin, double tmax, struct hit *hit)
{
    struct crossings_nearest nearest = { hit, false };
    crossings(shape, ray, tmin, tmax, crossings_take, &nearest);
    return nearest.found;
}

static inline bool crossings_add(void *context, const struct hit *hit)
{
    struct hits *hits = context;
    if (hits->count < HITS_MAX)
        hits->at[hits->count++] = *hit;
    return hits->count == HITS_MAX;
}

/* As primitive.intersect; those after HITS_MAX are left out. */
static inline void crossings_all(crossings_function *crossings,
                                 const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    crossings(shape, ray, -HUGE_VAL, HUGE_VAL, crossings_add, hits);
}

#endif
