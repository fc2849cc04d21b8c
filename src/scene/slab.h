/* Whether a ray meets a box (Kay and Kajiya 1986), in double precision. A
 * little generous, since it only tells what need not be looked at. */
#ifndef SCENE_SLAB_H
#define SCENE_SLAB_H

#include "base/affine.h"
#include "base/lesser.h"
#include "base/pair.h"
#include "scene/ray.h"

/* The ray with the inverse of its direction. */
struct slabs {
    vec3 origin, inverse;
};

/* No component is zero or infinite, so that no NaN can arise in slabs_hit. */
static inline double slab_inverse(double d)
{
    return fabs(d) > 1e-150 ? 1 / d : copysign(1e150, d);
}

static inline struct slabs slabs_of(const struct ray *ray)
{
    vec3 d = ray->direction;
    return (struct slabs){
        ray->origin, { slab_inverse(d.x), slab_inverse(d.y), slab_inverse(d.z) }
    };
}

/* The part of [*enter, *leave] between two parallel sides. */
static inline void slab_clip(double low, double high, double origin,
                             double inverse, double *enter, double *leave)
{
    double a = (low - origin) * inverse, b = (high - origin) * inverse;
    *enter = greater(*enter, lesser(a, b));
    *leave = lesser(*leave, greater(a, b));
}

/* The part of [*enter, *leave] in the box. */
static inline void slabs_clip(const struct slabs *slabs, const struct box3 *box,
                              double *enter, double *leave)
{
    vec3 o = slabs->origin, k = slabs->inverse;
    slab_clip(box->low.x, box->high.x, o.x, k.x, enter, leave);
    slab_clip(box->low.y, box->high.y, o.y, k.y, enter, leave);
    slab_clip(box->low.z, box->high.z, o.z, k.z, enter, leave);
}

/* Whether anything of it is left. */
static inline bool slabs_overlap(double enter, double leave)
{
    return enter <= leave + 1e-12 * (fabs(enter) + fabs(leave));
}

static inline bool slabs_hit(const struct slabs *slabs, const struct box3 *box,
                             double tmin, double tmax)
{
    slabs_clip(slabs, box, &tmin, &tmax);
    return slabs_overlap(tmin, tmax);
}

/* The part of [*enter, *leave] between two sides of two boxes, both at once. */
static inline void pair_clip(pair low, pair high, double origin, double inverse,
                             pair *enter, pair *leave)
{
    pair a = (low - origin) * inverse, b = (high - origin) * inverse;
    *enter = pair_max(*enter, pair_min(a, b));
    *leave = pair_min(*leave, pair_max(a, b));
}

/* slabs_hit of two boxes: bit by bit which of them it hits. */
static inline int slabs_hit_two(const struct slabs *slabs, const struct box3 *a,
                                const struct box3 *b, double tmin, double tmax)
{
    vec3 o = slabs->origin, k = slabs->inverse;
    pair enter = pair_of(tmin), leave = pair_of(tmax);
    pair_clip((pair){ a->low.x, b->low.x }, (pair){ a->high.x, b->high.x }, o.x,
              k.x, &enter, &leave);
    pair_clip((pair){ a->low.y, b->low.y }, (pair){ a->high.y, b->high.y }, o.y,
              k.y, &enter, &leave);
    pair_clip((pair){ a->low.z, b->low.z }, (pair){ a->high.z, b->high.z }, o.z,
              k.z, &enter, &leave);
    pair size = pair_max(enter, -enter) + pair_max(leave, -leave);
    return pair_ordered(enter, leave + 1e-12 * size);
}

#endif
