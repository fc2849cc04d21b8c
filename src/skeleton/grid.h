/* Where the voxels are: the part of the world that is looked at, and how fine
 * it is cut. */
#ifndef SKELETON_GRID_H
#define SKELETON_GRID_H

#include "world/world.h"
#include "skeleton/voxels.h"

/* How a grid is to be. */
struct grid_wish {
    int resolution; /* voxels along the longest side; 0: VOXELS_RESOLUTION */
    bool still;     /* a camera outside of all things counts for nothing, so
                     * that the grid stays where it is when the camera moves */
};

/* Places the grid around what is bounded, the camera, the lights and what they
 * see of planes; what is far beyond the rest is left outside. `empty` stays
 * NULL. False after an error was printed: so many voxels don't fit into
 * memory. */
bool grid_place(struct voxels *grid, const struct world *world,
                const struct camera *camera, struct grid_wish wish,
                struct diag *diag);

#endif
