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
    unsigned all;
    unsigned global; /* that lamps outside of light_groups are for */
    struct facets facets;
    struct occlusions ways; /* from them to the lamp at hand */
};

/* Up to RAY_LANES surfaces, which must stay. */
void lamplights_start(struct lamplights *lights,
                      const struct light_asker *askers, unsigned count);

/* Adds the light of one lamp. */
void lamplights_give(struct lamplights *lights, const struct lamp *lamp);

/* What all that were asked have given. */
void lamplights_end(const struct lamplights *lights, struct light_asker *askers,
                    unsigned count);

#endif
