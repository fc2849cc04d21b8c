/* The random points of a unit cube and the 26 around it, all looked at
 * together: for `crackle` (scene/pattern/crackle.c). */
#ifndef SCENE_CUBES_H
#define SCENE_CUBES_H

#include "base/vec.h"

/* The three smallest squares of distances from the place, each coordinate in
 * [0,1), in the cube whose lowest corner is `base`; increasing. */
void cubes_nearest(vec3 base, vec3 place, double squares[3]);

/* The smallest alone; returns how many cubes away its point's cube is. */
vec3 cubes_first(vec3 base, vec3 place, double *square);

/* From `base` to the point of the cube so many cubes away, at most 1 along each
 * axis. */
vec3 cubes_point(vec3 base, vec3 step);

#endif
