/* What a CSG object with cutaway_textures is made of that has a texture: where
 * a part without one cuts through it, its texture is seen. */
#ifndef SCENE_CUTAWAY_H
#define SCENE_CUTAWAY_H

#include <stddef.h>

struct object;

/* In the CSG object's space. The textures are a choice's entries, after one for
 * where there are none. */
struct cutaway {
    const struct object **objects;
    size_t count;
};

#endif
