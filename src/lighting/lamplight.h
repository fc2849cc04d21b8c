/* The light of single lamps as a surface gets it, once their visible share is
 * known: what `rays` and the light mesh with few lamps have in common. */
#ifndef LIGHTING_LAMPLIGHT_H
#define LIGHTING_LAMPLIGHT_H

#include "lighting/lighting.h"
#include "shade/lamps.h"

/* A surface point that gathers the light of lamps. */
struct lamplight {
    const struct lamps *lamps;
    struct worker *worker;
    const struct surface *surface;
    light_visit *visit;
    void *context;
    /* The share of the lamp's light that gets to the surface. */
    rgb (*share)(struct lamplight *light, const struct lamp *lamp,
                 const struct lamp_view *view);
    const void *knows; /* for `share`, if it wants anything */
};

/* Visits the samples of one lamp. `share` is asked only if the lamp can change
 * the picture. */
void lamplight_give(struct lamplight *light, const struct lamp *lamp);

/* Whether the lamp is behind the surface, as most that give nothing are, which
 * needs no unit vectors. */
bool lamplight_is_behind(const struct lamplight *light,
                         const struct lamp *lamp);

/* A share found by shadow rays at the surface itself. */
rgb lamplight_trace(struct lamplight *light, const struct lamp *lamp,
                    const struct lamp_view *view);

/* The same as of lamps_share_fine: nearer the truth for area lights. */
rgb lamplight_trace_fine(struct lamplight *light, const struct lamp *lamp,
                         const struct lamp_view *view);

#endif
