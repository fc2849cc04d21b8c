/* Fog and sky: see background.h. Measured on POV-Ray 3.7. */
#include "shade/background.h"

/* Constant fog: T = exp(-d / distance), but at least `transmit`; the light
 * behind is tinted by `filter`. Several fogs add up: each weakens what is
 * behind, none weakens another's light. */
struct veil fog_veil(const struct scene *scene, double distance)
{
    struct veil veil = { rgb_grey(0), rgb_grey(1) };
    for (size_t i = 0; i < scene->fogs.count; i++) {
        const struct fog *fog = &scene->fogs.items[i];
        rgb tone = colour_rgb(fog->colour);
        rgb tint = rgb_mix(rgb_grey(1), tone, fog->colour.filter);
        double left =
            fmax(exp(-distance / fog->distance), fog->colour.transmit);
        veil.light = rgb_add_scaled(veil.light, tone, 1 - left);
        veil.through = rgb_mul(veil.through, rgb_scale(tint, left));
    }
    return veil;
}

/* Pigments from the top down; `emission` brightens each, not what is seen
 * through it. */
struct veil sky_veil(const struct scene *scene, vec3 direction)
{
    struct veil veil = { rgb_grey(0), rgb_grey(1) };
    if (!scene->sky)
        return veil;
    for (size_t i = scene->sky->count; i-- > 0;) {
        colour c = pigment_colour(scene->sky->pigments[i], direction);
        rgb light = rgb_mul(colour_rgb(c), scene->sky->emission);
        light = rgb_scale(light, 1 - c.filter - c.transmit);
        veil.light = rgb_add(veil.light, rgb_mul(veil.through, light));
        veil.through = rgb_mul(veil.through, colour_transmittance(c));
    }
    return veil;
}
