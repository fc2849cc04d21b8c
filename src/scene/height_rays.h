/* Rays side by side over a grid of heights. */
#ifndef SCENE_HEIGHT_RAYS_H
#define SCENE_HEIGHT_RAYS_H

#include "scene/height_grid.h"
#include "scene/rays.h"

/* Where each of the run's rays, which are in the grid's space, first crosses
 * the triangles within its span: the first crossing of height_grid_crossings,
 * to the bit. */
void height_rays_first(const struct height_grid *grid, struct lane_run run,
                       const struct rays *rays, const struct rays_span *span,
                       struct rays_met *met);

#endif
