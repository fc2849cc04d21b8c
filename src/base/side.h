/* The six ways along the axes: 0 is +x, 1 -x, 2 +y ... */
#ifndef BASE_SIDE_H
#define BASE_SIDE_H

#include "base/vec.h"

enum { SIDES = 6 };

/* The side that a vector is closest to; its axis is side / 2. */
static inline int side_of(vec3 v)
{
    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(vec3_component(v, i)) > fabs(vec3_component(v, axis)))
            axis = i;
    return 2 * axis + (vec3_component(v, axis) < 0);
}

/* The unit vector that way. */
static inline vec3 side_normal(int side)
{
    double sign = side % 2 ? -1 : 1;
    return vec3_make(side / 2 == 0 ? sign : 0, side / 2 == 1 ? sign : 0,
                     side / 2 == 2 ? sign : 0);
}

/* And those along the next two axes. */
static inline vec3 side_across(int side)
{
    return side_normal(2 * ((side / 2 + 1) % 3));
}

static inline vec3 side_down(int side)
{
    return side_normal(2 * ((side / 2 + 2) % 3));
}

#endif
