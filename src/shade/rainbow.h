/* What rainbows add to a ray. */
#ifndef SHADE_RAINBOW_H
#define SHADE_RAINBOW_H

#include "shade/background.h"

/* All rainbows along the ray (its direction is unit) over `distance` from its
 * origin, INFINITY where it hits nothing. */
struct veil rainbow_veil(const struct scene *scene, const struct ray *ray,
                         double distance);

#endif
