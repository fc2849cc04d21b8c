/* Boxes that glow, as panels, screens and tubes with corners do: points of the
 * faces that a place sees are picked by the solid angle they fill. By area few
 * would be where such a face is close or seen at a grazing angle. */
#ifndef SHADE_EMITTER_BOX_H
#define SHADE_EMITTER_BOX_H

#include "shade/emitters.h"

/* Whether the leaf is a box, right-angled in the world, that is seen from
 * outside or inside and not turned inside out. */
bool emitter_box_is(const struct leaf *leaf);

/* Picks for a point: a face by `which`, a place on it by u, all in [0,1). The
 * density is that of the box alone. False: it sees none of it. */
bool emitter_box_pick(const struct leaf *leaf, vec3 point, double which,
                      const double u[2], struct emitter_pick *pick);

/* That density where a ray from the point met it; 0 where nothing is picked. */
double emitter_box_density(const struct leaf *leaf, vec3 point, vec3 met);

#endif
