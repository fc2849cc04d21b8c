/* Light of lamps by one shadow ray: of all lamps, or of some drawn evenly where
 * they are many, one is drawn by what it would give if nothing stood between
 * (resampled importance sampling: Talbot, Cline and Egbert 2005). Right in the
 * mean. */
#ifndef LIGHTMESH_DRAWN_LAMP_H
#define LIGHTMESH_DRAWN_LAMP_H

#include "base/draw.h"
#include "shade/lamps.h"

/* The irradiance of a place with this unit normal, in POV-Ray's units. Takes
 * the pairs of slots `slot` and `slot + 1`. */
rgb drawn_lamp_light(const struct lamps *lamps, struct worker *worker,
                     const struct draws *draws, uint32_t slot, vec3 place,
                     vec3 normal);

/* The same of each lamp, by a shadow ray for each. */
rgb each_lamp_light(const struct lamps *lamps, struct worker *worker,
                    const struct draws *draws, uint32_t slot, vec3 place,
                    vec3 normal);

#endif
