/* What a point of the indirect mesh keeps, and what a surface gets of it. */
#ifndef LIGHTMESH_INDIRECT_LIGHT_H
#define LIGHTMESH_INDIRECT_LIGHT_H

#include "lightmesh/harmonics.h"
#include "scene/light_settings.h"

struct indirect_light {
    struct harmonics light; /* first: a mesh_alone looks at it */
    float open[HARMONICS];  /* as harmonics: where ambient light comes in */
};

extern const struct indirect_light indirect_light_none;

/* Light, and the openness to what is outside, that one of many ways has which
 * are drawn with that density per solid angle; what is only right in the mean
 * may be less than 0. */
void indirect_light_add(struct indirect_light *light, vec3 direction,
                        rgb radiance, double open, double density);

/* sum += weight * from */
void indirect_light_mix(struct indirect_light *sum,
                        const struct indirect_light *from, float weight);
void indirect_light_scale(struct indirect_light *light, float factor);

/* Leaves only that share of each colour, and of the openness. */
void indirect_light_tint(struct indirect_light *light, rgb share);

/* Leaves only so much of the light, and of the openness. */
void indirect_light_dim(struct indirect_light *light, double factor,
                        double open);

/* What a receiver gets. */
struct indirect_share {
    rgb light;   /* indirect, that of glowing surfaces included, in POV-Ray's
                  * units */
    double open; /* of the ambient light outside, 0 to 1 */
};

/* So much of another's for as much of its own. */
static inline void indirect_share_mix(struct indirect_share *share,
                                      const struct indirect_share *other,
                                      double part)
{
    share->light = rgb_mix(share->light, other->light, part);
    share->open += (other->open - share->open) * part;
}

struct indirect_share indirect_light_share(const struct indirect_light *light,
                                           vec3 normal);

/* The same of a surface with a `side`, which hides what is behind it. Bumps
 * turn its normal; ambient light, as in POV-Ray, isn't any less for them: it
 * comes to the normal without, which is smooth. */
struct indirect_share indirect_light_bumped(const struct indirect_light *light,
                                            vec3 side, vec3 smooth,
                                            vec3 normal);

/* Light of surfaces as POV-Ray's radiosity has it (measured): brighter, or with
 * less colour. */
rgb bounce_toned(const struct bounce_tone *tone, rgb light);

#endif
