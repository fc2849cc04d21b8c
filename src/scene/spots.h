/* Some points side by side, coordinate by coordinate: what is asked for at all
 * of them is worked out for several at a time. */
#ifndef SCENE_SPOTS_H
#define SCENE_SPOTS_H

#include "base/affine.h"
#include "base/octet.h"
#include "base/vec.h"

enum { SPOTS_MAX = 2 * OCTET };

struct spots {
    int count;
    double x[SPOTS_MAX], y[SPOTS_MAX], z[SPOTS_MAX];
};

static inline void spots_put(struct spots *spots, int i, vec3 point)
{
    spots->x[i] = point.x;
    spots->y[i] = point.y;
    spots->z[i] = point.z;
}

static inline void spots_add(struct spots *spots, vec3 point)
{
    spots_put(spots, spots->count++, point);
}

static inline vec3 spots_at(const struct spots *spots, int i)
{
    return vec3_make(spots->x[i], spots->y[i], spots->z[i]);
}

static inline struct spots spots_of(vec3 point)
{
    struct spots spots; /* no more of it than is needed */
    spots.count = 0;
    spots_add(&spots, point);
    return spots;
}

/* They are `moved` by the transform. */
void spots_moved(const struct spots *restrict spots, const affine *transform,
                 struct spots *restrict moved);

#endif
