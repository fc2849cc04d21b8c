/* Whether a point stays under a julia_fractal's steps, quickly: what rays ask
 * at each of their own steps. */
#ifndef SCENE_JULIA_FATE_H
#define SCENE_JULIA_FATE_H

#include "scene/julia_fractal.h"

struct julia_fate {
    bool gone;
    double distance; /* a ray may go on so far before that changes: by an
                      * estimate that is nearly as far as can be; or 0 */
};

void julia_fate_find(const struct julia_fractal *fractal, vec3 point,
                     struct julia_fate *fate);

#endif
