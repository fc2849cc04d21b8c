/* What a shape whose crossings come in no order looks for on a ray: all of
 * them, or the first. */
#ifndef SCENE_HIT_SEARCH_H
#define SCENE_HIT_SEARCH_H

#include "scene/rays.h"

/* Between tmin and tmax: all into `all`, or, if that is NULL, the first into
 * `first`, and then tmax is where that is. `all` belongs to the caller. */
struct hit_search {
    double tmin, tmax;
    struct hits *all;
    struct hit first;
    bool found; /* `first` has one */
};

static inline bool hit_search_wants(const struct hit_search *search, double t)
{
    return t > search->tmin && t < search->tmax;
}

/* Those beyond HITS_MAX are left out. */
static inline void hit_search_take(struct hit_search *search, struct hit hit)
{
    if (!hit_search_wants(search, hit.t))
        return;
    if (search->all) {
        if (search->all->count < HITS_MAX)
            search->all->at[search->all->count++] = hit;
        return;
    }
    search->first = hit;
    search->tmax = hit.t;
    search->found = true;
}

/* What the search of lane `i` has found. */
static inline void rays_met_take(struct rays_met *met, int i,
                                 const struct hit_search *search)
{
    met->t[i] = search->found ? search->first.t : (double)INFINITY;
    met->part[i] = search->found ? search->first.part : 0;
    met->u[i] = search->found ? search->first.u : 0;
}

#endif
