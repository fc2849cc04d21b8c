/* Where to look for light that doesn't come straight: skeleton-guided sampling
 * (after Biri and Chaussard, "Skeleton based importance sampling for path
 * tracing", Eurographics 2012 short papers, who look along the way to the
 * lamp). Each node of the skeleton of the void knows how bright what it sees
 * is, by the balance of light between chambers (heuristic network); from every
 * point nearby light is looked for in lobes around what is brightest. How much
 * light there is serves roulette and splitting of paths. */
#ifndef LIGHTING_GUIDE_H
#define LIGHTING_GUIDE_H

#include "lighting/lighting.h"

enum { GUIDE_TARGETS = 8 }; /* at a point; the strongest */

/* Lobes: directions to be drawn with density (power + 1)/(2 pi) cos^power
 * around the axis, this often; the rest of the chance is the caller's. */
struct guide_aim {
    int count;
    double light; /* indirect irradiance, about, the largest of the colours */
    struct guide_lobe {
        vec3 axis; /* unit, in front of the surface */
        double power, chance;
    } at[GUIDE_TARGETS];
};

/* NULL after an error was printed. Free with guide_free; the same for any
 * number of threads. */
struct guide *guide_new(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag);
void guide_free(struct guide *guide);

/* Whether there is more light in some places of the void than in others; if
 * not, guided paths find it no sooner. */
bool guide_useful(const struct guide *guide);

/* What is known of a point of a surface; lobes may be none, and are none where
 * lamps are seen (`lit`). Depends on the point and its unit normal alone. */
void guide_look(const struct guide *guide, vec3 point, vec3 normal, bool lit,
                struct guide_aim *aim);

#endif
