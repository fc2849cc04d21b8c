/* The parameters of the slope pattern. */
#ifndef SCENE_SLOPE_H
#define SCENE_SLOPE_H

#include "base/vec.h"

struct slope {
    vec3 direction; /* or, with point_at, a place */
    bool point_at;
    double slopes[2]; /* where the value is 0 and where it is 1 */
    vec3 altitude;    /* upwards; 0: only the slope counts */
    double altitudes[2];
};

#endif
