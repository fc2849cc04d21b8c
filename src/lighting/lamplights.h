/* Lamps' light at several surfaces together, as those that neighbouring pixels
 * see: each gets to the bit what lamplight_give gives it. */
#ifndef LIGHTING_LAMPLIGHTS_H
#define LIGHTING_LAMPLIGHTS_H

#include "lighting/lamplight.h"
#include "shade/facets.h"

/* Bits stand for surfaces. */
struct lamplights {
    const struct lamps *lamps;
    struct worker *worker;
    struct facets *facets;
    unsigned global;        /* that lamps outside of light_groups are for */
    struct occlusions ways; /* from them to the lamp at hand */
};

/* From the facets that are set, which must stay. */
void lamplights_start(struct lamplights *lights, struct facets *facets);

/* Adds the light of one lamp to theirs. */
void lamplights_give(struct lamplights *lights, const struct lamp *lamp);

#endif
