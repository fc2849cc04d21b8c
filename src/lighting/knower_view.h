/* --show knower: who of the ladder (lightmesh/knower.h) told the light of lamps
 * at places of the picture. */
#ifndef LIGHTING_KNOWER_VIEW_H
#define LIGHTING_KNOWER_VIEW_H

#include "lighting/mesh_lamps.h"
#include "lighting/show.h"

/* A point where the camera first sees a surface, for each of a grid of pixels;
 * its number is that of the last knower on the ladder that was needed there. */
void knower_view_give(const struct mesh_lamps *lamps, int width, int height,
                      struct show *show);

#endif
