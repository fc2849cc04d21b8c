/* What a gather ray sees of a surface: paint as wide as what the ray stands
 * for.
 */
#ifndef LIGHTMESH_GATHER_PAINT_H
#define LIGHTMESH_GATHER_PAINT_H

#include "shade/surface.h"

struct gather;

/* The surface that a gather ray met; `at` must stay as long. Of `gather` only
 * the lamps count. */
void gather_surface(const struct gather *gather, const struct ray *ray,
                    const struct intersection *at, struct surface *surface);

/* Where the surface's paint is a block pattern (checker, brick, ...) its colour
 * becomes the mean over a disc of that radius around the point: rays of
 * neighbouring mesh points, which meet one block or the next, then bring as
 * much. Other paint stays: it differs less from place to place than it costs.
 */
void gather_paint(struct surface *surface, double radius);

/* What a gather ray gets of irradiance of the surface, of which the part `sky`
 * is open (surface_sky). */
rgb gather_albedo(const struct surface *surface, double sky);

#endif
