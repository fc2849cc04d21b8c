/* Lamps' light at several surfaces together, as those that neighbouring pixels
 * see: each gets to the bit what lamplight_give gives it. */
#ifndef LIGHTING_LAMPLIGHTS_H
#define LIGHTING_LAMPLIGHTS_H

#include "lighting/lamplight.h"
#include "shade/facets.h"

/* What is known of a lamp before any shadow ray is sent: which of `lanes` it
 * shines on, and which it doesn't. */
struct lamplights_known {
    unsigned lit, dark;
};

/* Bits stand for surfaces. */
struct lamplights {
    const struct lamps *lamps;
    struct worker *worker;
    /* As of a lamplight: the share of what is not wholly lit or wholly dark. */
    rgb (*share)(struct lamplight *light, const struct lamp *lamp,
                 const struct lamp_view *view);
    /* lamps_share or lamps_share_fine if `share` is that, and nothing else is
     * known; else NULL. */
    rgb (*traced)(const struct lamps *lamps, const struct lamp *lamp,
                  struct worker *worker, const struct lamp_target *target);
    const void *knows; /* for `share` and `foresee` */
    /* NULL: nothing is known. */
    struct lamplights_known (*foresee)(const struct lamplights *lights,
                                       const struct lamp *lamp, unsigned lanes);
    struct facets *facets;
    unsigned global;        /* that lamps outside of light_groups are for */
    struct occlusions ways; /* from them to the lamp at hand */
};

/* From the facets that are set, which must stay; what is above `facets` is set
 * by the caller. */
void lamplights_start(struct lamplights *lights, struct facets *facets);

/* Adds the light of one lamp to theirs. */
void lamplights_give(struct lamplights *lights, const struct lamp *lamp);

#endif
