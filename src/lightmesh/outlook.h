/* How the camera sees the scene, from a few rays: how large pixels are on the
 * surfaces, and where these are. What a mesh's spacing is chosen from. */
#ifndef LIGHTMESH_OUTLOOK_H
#define LIGHTMESH_OUTLOOK_H

#include "world/world.h"
#include "lightmesh/lattice.h"

struct outlook {
    vec3 centre;     /* of what is seen */
    double size;     /* across it, without what is exceptionally far; > 0 */
    double pixel;    /* width of a pixel on most surfaces, > 0 */
    double across;   /* of the whole picture there, as wide as its pixels are */
    double distance; /* where it is that wide; 0: everywhere (orthographic) */
};

/* For a picture of so many pixels across. */
struct outlook outlook_of(const struct world *world, const struct scene *scene,
                          int width);

#endif
