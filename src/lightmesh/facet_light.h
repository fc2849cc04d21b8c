/* The light of many lamps on one side of a flat piece of surface. Only lamps
 * before the surface are asked, those that could give much more often: where
 * all of them are seen the sum is exact, and where not, what is estimated is
 * the share that is seen. */
#ifndef LIGHTMESH_FACET_LIGHT_H
#define LIGHTMESH_FACET_LIGHT_H

#include "base/worker.h"
#include "shade/lamps.h"

struct light_tree;

/* x, y, z: the sum of the directions that light comes from, each times its
 * light, and fourth the sum of the light alone. All of it comes from before
 * the surface, so that on the surface itself the vector times the normal is
 * the irradiance and no cosine is lost. */
struct facet_light {
    float r[4], g[4], b[4];
};

/* A piece of surface that asks. */
struct facet_site {
    vec3 place;    /* its middle */
    vec3 edge[2];  /* of a triangle around it, in which rays begin: the light
                    * is a mean over that; may be zero */
    vec3 normal;   /* unit, to the side that is lit */
    int budget;    /* lamps to ask, 1 or more */
    uint64_t key;  /* of what may look random */
    double dither; /* in [0,1): sites near each other with numbers far apart
                    * ask different lamps */
};

/* The lamps made ready to be asked by many sites. Frees with
 * facet_lamps_free; lamps and tree must outlive it. */
struct facet_lamps;
struct facet_lamps *facet_lamps_new(const struct lamps *lamps,
                                    const struct light_tree *tree);
void facet_lamps_free(struct facet_lamps *lamps);

/* Adds the light that reaches the site. Depends on the site alone. */
void facet_lamps_ask(const struct facet_lamps *lamps, struct worker *worker,
                     const struct facet_site *site, struct facet_light *light);

/* sum += weight * from */
void facet_light_mix(struct facet_light *sum, const struct facet_light *from,
                     double weight);

/* All of it, without cosines, and how much that is. */
rgb facet_light_total(const struct facet_light *light);
double facet_light_amount(const struct facet_light *light);

/* The light on a surface whose true normal is `side` and which is shaded with
 * `normal`, weighted with cosine^brilliance: Lambert's law for 1. */
rgb facet_light_irradiance(const struct facet_light *light, vec3 side,
                           vec3 normal, double brilliance);

/* As harmonics_direction. */
vec3 facet_light_direction(const struct facet_light *light, rgb *from_there);

#endif
