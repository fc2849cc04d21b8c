/* The noise of noise_generator 3; see perlin.c. */
#ifndef SCENE_PERLIN_H
#define SCENE_PERLIN_H

#include "base/vec.h"

/* About [-1,1], 0 at lattice points, one feature per unit. Defined as
 * noise_value is. */
double perlin_noise(vec3 point);

#endif
