/* Paint as wide as what a gather ray stands for. */
#ifndef LIGHTMESH_GATHER_PAINT_H
#define LIGHTMESH_GATHER_PAINT_H

#include "shade/surface.h"

/* Where the surface's paint is a block pattern (checker, brick, ...) its colour
 * becomes the mean over a disc of that radius around the point: rays of
 * neighbouring mesh points, which meet one block or the next, then bring as
 * much. Other paint stays: it differs less from place to place than it costs.
 */
void gather_paint(struct surface *surface, double radius);

#endif
