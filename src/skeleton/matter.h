/* What stops light: the leaves and textures that voxels and walls are made
 * of. */
#ifndef SKELETON_MATTER_H
#define SKELETON_MATTER_H

#include <stdint.h>

#include "world/world.h"

enum {
    MATTER_WALL = 1,    /* stops light */
    MATTER_EMITTER = 2, /* and has an emission */
};

/* One byte for each leaf by number, in `arena`. 0: it casts no shadow, or lets
 * more light pass than it keeps. `space` is the part of the world looked at. */
const uint8_t *matter_marks(const struct world *world, struct box3 space,
                            struct arena *arena);

/* The same of one texture, in the part of the world that `box` is. */
uint8_t matter_of_texture(const struct texture *texture,
                          const affine *to_texture, struct box3 box);

/* Whether something with a mark lies between the two points. */
bool matter_hides(const struct world *world, const uint8_t *marks, vec3 from,
                  vec3 to);

#endif
