/* How many mesh points a picture will ask for, counted before any is made: a
 * few camera rays, and what would be gathered where they end. */
#ifndef LIGHTMESH_CENSUS_H
#define LIGHTMESH_CENSUS_H

#include <stdatomic.h>

#include "lightmesh/direct.h"
#include "lightmesh/indirect.h"
#include "scene/scene.h"

struct census {
    const struct scene *scene;
    const struct direct_mesh *direct;
    bool space, surfaces; /* of the direct mesh: which the camera asks */
    const struct indirect_mesh *indirect;           /* or NULL */
    struct lattice_view direct_view, indirect_view; /* of the camera */
    double pixels;                                  /* of the picture, > 0 */
    const atomic_int *stop; /* non-zero: leave off, and count what there is;
                             * NULL: never */
};

/* The largest number of points for which there is room once, over the meshes:
 * above 1 some have no room, and would be worked out again and again. An
 * estimate, the same on every machine. */
double census_crowding(const struct census *census);

/* How many points the indirect mesh of the first bounce will have, roughly. */
double census_gathered(const struct census *census);

#endif
