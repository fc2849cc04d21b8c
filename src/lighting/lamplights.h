/* Lamps' light at several surfaces together, as those that neighbouring pixels
 * see: each gets to the bit what lamplight_give gives it. */
#ifndef LIGHTING_LAMPLIGHTS_H
#define LIGHTING_LAMPLIGHTS_H

#include "lighting/lamplight.h"

/* How surfaces that stand side by side face lamps. */
struct facets {
    double point[3][RAY_LANES];
    double normal[3][RAY_LANES]; /* of the only layer */
    /* Whether light from its front and its back does anything to it, and
     * whether both sides are its front. */
    lane_flag front[RAY_LANES], back[RAY_LANES], twice[RAY_LANES];
};

/* Bits stand for surfaces. */
struct lamplights {
    struct lamplight *each;
    unsigned count;
    unsigned layered; /* of other than one layer, which face as all those do */
    struct facets facets;
    struct occlusions ways; /* from them to the lamp at hand */
};

/* Of up to RAY_LANES, which must stay. */
void lamplights_start(struct lamplights *lights, struct lamplight *each,
                      unsigned count);

/* Visits the samples of one lamp. */
void lamplights_give(struct lamplights *lights, const struct lamp *lamp);

#endif
