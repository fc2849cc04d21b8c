/* Shadow rays: what part of a lamp's light gets from there to here. */
#ifndef SHADE_SHADOW_H
#define SHADE_SHADOW_H

#include "base/worker.h"
#include "shade/surface.h"

/* The share of light number `light` (-1: of nothing that looks like a light)
 * that gets to the surface's point from `distance` away in the unit
 * `direction`, tinted by transparent objects and faded by their interiors;
 * black in full shadow. A distance that isn't positive leaves room for
 * nothing: white. */
rgb shadow_visibility(const struct world *world, struct worker *worker,
                      const struct surface *surface, vec3 direction,
                      double distance, int light);

/* How far from a surface point the next ray begins to see: POV-Ray's 1e-4
 * (measured), and what single precision needs far from the origin. */
double surface_offset(vec3 point);

#endif
