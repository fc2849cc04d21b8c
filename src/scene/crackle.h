/* The cells of the crackle pattern. */
#ifndef SCENE_CRACKLE_H
#define SCENE_CRACKLE_H

#include "base/vec.h"

/* The random point whose cell the point is in. */
vec3 crackle_centre(vec3 point);

#endif
