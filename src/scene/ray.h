/* Rays and the hits of a ray with one shape. */
#ifndef SCENE_RAY_H
#define SCENE_RAY_H

#include <stdbool.h>

#include "base/vec.h"

/* Points origin + t direction. The direction need not be unit: a ray taken
 * into an object's own space keeps its parameter t. */
struct ray {
    vec3 origin, direction;
};

/* One crossing of a shape's surface. `part` and u, v mean what the shape
 * wants (which face, barycentric coordinates): given back to its normal(). */
struct hit {
    double t;
    int part;
    double u, v;
};

/* Takes a crossing; returns true when no more are wanted. */
typedef bool hit_visit(void *context, const struct hit *hit);

/* Every crossing of one shape, in any order. A poly{} of order 35 could have
 * three more, were it made to. */
enum { HITS_MAX = 32 };

struct hits {
    int count;
    struct hit at[HITS_MAX];
};

static inline void hits_add(struct hits *hits, double t, int part)
{
    if (hits->count < HITS_MAX)
        hits->at[hits->count++] = (struct hit){ t, part, 0, 0 };
}

/* Whether one of them lies between tmin and tmax. */
static inline bool hits_between(const struct hits *hits, double tmin,
                                double tmax)
{
    for (int i = 0; i < hits->count; i++)
        if (hits->at[i].t > tmin && hits->at[i].t < tmax)
            return true;
    return false;
}

/* The nearest of them. */
static inline bool hits_first(const struct hits *hits, double tmin, double tmax,
                              struct hit *hit)
{
    bool found = false;
    for (int i = 0; i < hits->count; i++) {
        if (!(hits->at[i].t > tmin && hits->at[i].t < tmax))
            continue;
        *hit = hits->at[i];
        tmax = hit->t;
        found = true;
    }
    return found;
}

/* Round the y axis from x by z, 0 to 1: the first of many shapes' own
 * coordinates. */
static inline double ray_turn(double x, double z)
{
    double turn = atan2(z, x) / (2 * M_PI);
    return turn < 0 ? turn + 1 : turn;
}

static inline vec3 ray_point(const struct ray *ray, double t)
{
    return vec3_along(ray->origin, ray->direction, t);
}

#endif
