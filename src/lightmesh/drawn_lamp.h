/* Light of lamps by one shadow ray: of all lamps, or of some drawn evenly where
 * they are many, one is drawn by what it would give if nothing stood between
 * (resampled importance sampling: Talbot, Cline and Egbert 2005). Right in the
 * mean. */
#ifndef LIGHTMESH_DRAWN_LAMP_H
#define LIGHTMESH_DRAWN_LAMP_H

#include "base/draw.h"
#include "shade/lamps.h"

/* What is lit. */
struct lit_place {
    vec3 point, normal;      /* unit */
    const struct leaf *leaf; /* whose lamps alone light it; NULL: all do */
    const struct finish
        *finish; /* by which the cosine counts; NULL: as it is */
};

/* Its irradiance, in POV-Ray's units. Takes the pairs of slots `slot` and
 * `slot + 1`. */
rgb drawn_lamp_light(const struct lamps *lamps, struct worker *worker,
                     const struct draws *draws, uint32_t slot,
                     const struct lit_place *place);

/* The same of each lamp, by a shadow ray for each. */
rgb each_lamp_light(const struct lamps *lamps, struct worker *worker,
                    const struct draws *draws, uint32_t slot,
                    const struct lit_place *place);

/* Several places, those of the bits `lanes`. */
struct lit_places {
    unsigned lanes;
    struct lit_place at[RAY_LANES];
    struct draws draws[RAY_LANES];
    rgb light[RAY_LANES]; /* that they get */
};

/* Each lamp's light on all of them: shadow rays to one lamp go together. */
void each_lamp_many(const struct lamps *lamps, struct worker *worker,
                    uint32_t slot, struct lit_places *places);

#endif
