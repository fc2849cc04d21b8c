/* Light for pieces of the void that have no walls of their own. */
#ifndef SKELETON_SPREAD_H
#define SKELETON_SPREAD_H

#include "base/rgb.h"
#include "skeleton/pieces.h"

struct piece_light {
    rgb light; /* in any unit: it is averaged alone */
    bool known;
};

/* Those of `light`, one for each piece, that aren't known get the mean of those
 * beside them that are, by the faces of voxels that they share; then those
 * beside these, and so on. Pieces that nothing known leads to stay unknown. */
void spread_light(const struct pieces *pieces, const struct voxels *voxels,
                  struct piece_light *light);

#endif
