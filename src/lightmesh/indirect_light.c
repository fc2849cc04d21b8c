/* Light of one indirect mesh point: see indirect_light.h. */
#include "lightmesh/indirect_light.h"

#include "base/warp.h"
#include "shade/surface.h"

const struct indirect_light indirect_light_none = { { { 0 }, { 0 }, { 0 } },
                                                    { 0 } };

/* The mean over a hemisphere weighted with the cosine is 1/pi of the
 * integral. */
void indirect_light_add(struct indirect_light *light, vec3 direction,
                        rgb radiance, double open, double density)
{
    double weight = 1 / (WARP_PI * density);
    if (radiance.r != 0 || radiance.g != 0 || radiance.b != 0)
        harmonics_add(&light->light, direction, rgb_scale(radiance, weight));
    if (open != 0)
        harmonics_add_share(light->open, direction, open * weight);
}

void indirect_light_mix(struct indirect_light *sum,
                        const struct indirect_light *from, float weight)
{
    harmonics_mix(&sum->light, &from->light, weight);
    for (int i = 0; i < HARMONICS; i++)
        sum->open[i] += weight * from->open[i];
}

void indirect_light_scale(struct indirect_light *light, float factor)
{
    struct indirect_light sum = indirect_light_none;
    indirect_light_mix(&sum, light, factor);
    *light = sum;
}

void indirect_light_dim(struct indirect_light *light, double factor,
                        double open)
{
    struct harmonics sum = indirect_light_none.light;
    harmonics_mix(&sum, &light->light, (float)factor);
    light->light = sum;
    for (int i = 0; i < HARMONICS; i++)
        light->open[i] *= (float)open;
}

void indirect_light_tint(struct indirect_light *light, rgb share)
{
    for (int i = 0; i < HARMONICS; i++) {
        light->light.r[i] *= (float)share.r;
        light->light.g[i] *= (float)share.g;
        light->light.b[i] *= (float)share.b;
        light->open[i] *= (float)rgb_brightness(share);
    }
}

/* By weights of light, and of openness. */
static struct indirect_share
indirect_light_weighted(const struct indirect_light *light,
                        const double weights[HARMONICS],
                        const double open[HARMONICS])
{
    return (struct indirect_share){
        harmonics_weighted(&light->light, weights),
        harmonics_weighted_share(light->open, open),
    };
}

struct indirect_share indirect_light_share(const struct indirect_light *light,
                                           vec3 normal)
{
    double weights[HARMONICS];
    harmonics_weights(normal, 1, weights);
    return indirect_light_weighted(light, weights, weights);
}

struct indirect_share indirect_light_bumped(const struct indirect_light *light,
                                            vec3 side, vec3 smooth, vec3 normal)
{
    double weights[HARMONICS], open[HARMONICS];
    harmonics_bump(side, normal, weights);
    if (vec3_same(smooth, normal))
        return indirect_light_weighted(light, weights, weights);
    harmonics_bump(side, smooth, open);
    return indirect_light_weighted(light, weights, open);
}

rgb bounce_toned(const struct bounce_tone *tone, rgb light)
{
    rgb grey = rgb_grey(rgb_brightness(light));
    if (tone->grey != 0)
        light = rgb_mix(light, grey, tone->grey);
    return rgb_scale(light, tone->brightness);
}
