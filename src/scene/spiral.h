/* What spiral1 and spiral2 have in common. */
#ifndef SCENE_SPIRAL_H
#define SCENE_SPIRAL_H

#include "scene/noise.h"

/* How far the arms have gone around and along the z axis, in arms. Measured:
 * angles are counted from -y, and the turbulence that has moved the point
 * already turns the arms once more. */
static inline double spiral_winding(const struct pattern *pattern, int arms,
                                    vec3 point)
{
    double turn = 0.25 + atan2(point.y, point.x) / (2 * M_PI);
    double bend = 0;
    if (pattern->turbulent)
        bend = pattern->turbulence.amount.x *
               noise_turbulence(pattern_generator(pattern), point,
                                &pattern->turbulence);
    return point.z + arms * turn + bend;
}

#endif
