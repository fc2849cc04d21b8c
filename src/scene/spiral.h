/* What spiral1 and spiral2 have in common. */
#ifndef SCENE_SPIRAL_H
#define SCENE_SPIRAL_H

#include <string.h>

#include "base/octet_math.h"
#include "scene/noise.h"
#include "scene/spots.h"

/* How far spots are from the z axis, and the arms have gone around and along it
 * there, in arms. Measured: angles are counted from -y, and the turbulence that
 * has moved the point already turns the arms once more. */
static inline void spiral_winding(const struct pattern *pattern, int arms,
                                  const struct spots *spots, double *radii,
                                  double *windings)
{
    double bends[SPOTS_MAX] = { 0 };
    int count = spots->count;
    memcpy(windings, spots->y, (size_t)count * sizeof *windings);
    numbers_atan2(windings, spots->x, count);
    if (pattern->turbulent)
        noise_turbulences(pattern_generator(pattern), spots,
                          &pattern->turbulence, bends);
    for (int i = 0; i < count; i++) {
        double x = spots->x[i], y = spots->y[i];
        double turn = 0.25 + windings[i] / (2 * M_PI);
        radii[i] = sqrt(x * x + y * y);
        windings[i] =
            spots->z[i] + arms * turn + pattern->turbulence.amount.x * bends[i];
    }
}

#endif
