/* The random points of a unit cube and the 26 around it, all looked at
 * together: for `crackle` (scene/pattern/crackle.c). */
#ifndef SCENE_CUBES_H
#define SCENE_CUBES_H

#include "base/vec.h"

/* The three smallest squares of distances from the place, each coordinate in
 * [0,1), in the cube whose lowest corner is `base`; increasing. */
void cubes_nearest(vec3 base, vec3 place, double squares[3]);

#endif
