/* Diffuse reflection, highlights and mirrors: see finish.h. */
#include "shade/finish.h"

#include <string.h>

#include "base/power.h"
#include "base/random.h"

/* Diffuse reflection of light at `cosine` to the normal (negative: from
 * behind). */
static double finish_diffuse(const struct finish *finish, double cosine,
                             bool twice)
{
    double share = cosine > 0 || twice ? finish->diffuse : finish->diffuse_back;
    if (share == 0 || cosine == 0)
        return 0;
    return share * finish_cosine(finish, fabs(cosine));
}

static uint64_t bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* crand: each lamp's diffuse light loses a random part, uniform up to crand,
 * not clipped; by the point and the lamp's direction alone. */
static double finish_grain(const struct finish *finish, vec3 point, vec3 light)
{
    uint64_t key = random_key(bits_of(point.x), bits_of(point.y));
    key = random_key(key, bits_of(point.z));
    key = random_key(key, bits_of(light.x + 2 * light.y + 4 * light.z));
    return finish->crand * random_unit(key);
}

double finish_diffused(const struct finish *finish,
                       const struct finish_meeting *meeting, vec3 point,
                       bool twice, double opacity)
{
    double cosine = vec3_dot(meeting->normal, meeting->light);
    double diffuse = finish_diffuse(finish, cosine, twice) * opacity;
    if (finish->crand > 0 && diffuse != 0)
        diffuse -= finish_grain(finish, point, meeting->light);
    return diffuse;
}

/* What one layer sends of it, before the layer's weight: diffuse, phong and
 * specular. */
static inline rgb finish_light(const struct surface *surface,
                               const struct surface_layer *layer,
                               const struct light_sample *sample)
{
    const struct finish *finish = layer->finish;
    double cosine = vec3_dot(layer->normal, sample->direction);
    bool twice = surface->at->leaf->look->double_illuminate;
    const struct finish_meeting meeting = { layer->normal, surface->view,
                                            sample->direction };
    double diffuse = sample->diffused
                         ? 0
                         : finish_diffused(finish, &meeting, surface->point,
                                           twice, layer_opacity(layer));
    rgb share = rgb_scale(colour_rgb(layer->pigment), diffuse);
    if ((cosine > 0 || twice) && sample->highlights && finish_shines(finish)) {
        rgb highlights =
            finish_highlights_tinted(finish, finish_highlight(finish, &meeting),
                                     colour_rgb(layer->pigment), cosine);
        share = rgb_add(share, highlights);
    }
    if (finish_tints(finish))
        share = rgb_mul(
            share, finish_tint(finish, surface->point, cosine,
                               fabs(vec3_dot(surface->view, layer->normal))));
    return rgb_mul(share, sample->colour);
}

void surface_add_light(const struct surface *surface,
                       const struct light_sample *sample, rgb *sum)
{
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb light = finish_light(surface, layer, sample);
        *sum = rgb_add(*sum, rgb_mul(layer->weight, light));
    }
}

rgb finish_glow(const struct surface_layer *layer, rgb ambient, rgb irradiance)
{
    rgb light = finish_given(layer->finish, ambient, irradiance);
    light = rgb_mul(light, colour_rgb(layer->pigment));
    return rgb_scale(light, layer_opacity(layer));
}

rgb finish_ambient(const struct surface_layer *layer)
{
    rgb share = rgb_mul(layer->finish->ambient, colour_rgb(layer->pigment));
    return rgb_scale(share, layer_opacity(layer));
}

rgb finish_shine(const struct surface_layer *layer)
{
    rgb light = rgb_mul(layer->finish->glow, colour_rgb(layer->pigment));
    return rgb_scale(light, layer_opacity(layer));
}

double finish_fresnel(double cosine, double ior)
{
    double sine2 = (1 - cosine * cosine) / (ior * ior);
    if (!(sine2 < 1))
        return 1;
    double t = sqrt(1 - sine2);
    double s = (cosine - ior * t) / (cosine + ior * t);
    double p = (ior * cosine - t) / (ior * cosine + t);
    return (s * s + p * p) / 2;
}

/* An empirical Fresnel curve of the angle x, in right angles:
 * F = 0.014567225 / (x - 1.12)^2 - 0.011612903, cut to [0,1]; light from
 * behind has x > 1. */
rgb finish_metallic(double metallic, double cosine, rgb pigment)
{
    if (metallic == 0)
        return rgb_grey(1);
    double x =
        acos(lesser(greater(cosine, -1), 1)) / (3.14159265358979323846 / 2);
    double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
    f = lesser(greater(f, 0), 1);
    rgb tint = rgb_sub(pigment, rgb_grey(1));
    return rgb_add_scaled(rgb_grey(1), tint, metallic * (1 - f));
}

static double largest_of(rgb share)
{
    return greater(share.r, greater(share.g, share.b));
}

/* A mirror that is stronger at an angle sends rays for the strongest that it
 * can be, wherever it is seen from; by Fresnel for what it is (measured, by
 * adc_bailout). */
struct finish_mirror finish_mirror(const struct finish *finish, rgb pigment,
                                   double cosine, double ior)
{
    const struct reflection *mirror = &finish->reflection;
    rgb range = rgb_sub(mirror->maximum, mirror->minimum);
    rgb share = mirror->minimum;
    if (rgb_peak(mirror->maximum) == 0 && rgb_peak(share) == 0)
        return (struct finish_mirror){ rgb_grey(0), rgb_grey(0), 0 };
    if (mirror->fresnel)
        share = rgb_add_scaled(share, range,
                               finish_fresnel(greater(cosine, 0), ior));
    else if (rgb_peak(range) != 0)
        share = rgb_add_scaled(
            share, range, power_of(1 - lesser(cosine, 1), mirror->falloff));
    double weight = mirror->fresnel ? largest_of(share)
                                    : greater(largest_of(mirror->minimum),
                                              largest_of(mirror->maximum));
    rgb tint = finish_metallic(mirror->metallic, cosine, pigment);
    rgb mirrored = rgb_mul(share, tint);
    return (struct finish_mirror){ mirrored, mirrored, weight };
}

static double power_of_light(double light, double exponent)
{
    return light > 0 ? pow(light, exponent) : 0;
}

rgb finish_raised(rgb light, double exponent)
{
    return (rgb){ power_of_light(light.r, 1 / exponent),
                  power_of_light(light.g, 1 / exponent),
                  power_of_light(light.b, 1 / exponent) };
}

rgb surface_glow(const struct surface *surface)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        if (rgb_peak(layer->finish->emission) == 0)
            continue;
        rgb glow = finish_glow(layer, rgb_grey(0), rgb_grey(0));
        sum = rgb_add(sum, rgb_mul(layer->weight, glow));
    }
    return sum;
}

rgb surface_shine(const struct surface *surface)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        if (rgb_peak(layer->finish->glow) > 0)
            sum = rgb_add(sum, rgb_mul(layer->weight, finish_shine(layer)));
    }
    return sum;
}

static rgb surface_scattered(const struct surface *surface)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double share = layer->finish->diffuse * layer_opacity(layer);
        rgb albedo = rgb_scale(colour_rgb(layer->pigment), share);
        sum = rgb_add(sum, rgb_mul(layer->weight, albedo));
    }
    return sum;
}

rgb surface_albedo(const struct surface *surface)
{
    return albedo_bounded(surface_scattered(surface), RETURNED_MOST);
}

static double surface_returned_most(const struct surface *surface)
{
    double most = RETURNED_MOST;
    for (int i = 0; i < surface->count; i++)
        most = fmin(most, surface->layer[i].finish->returned_most);
    return most;
}

double surface_restraint(const struct surface *surface)
{
    double peak = rgb_peak(surface_scattered(surface));
    double most = surface_returned_most(surface);
    return peak > most ? most / peak : 1;
}

double surface_behind(const struct surface *surface)
{
    const struct finish *finish = surface->layer[0].finish;
    if (surface->count == 0)
        return 0;
    return finish_behind(finish->diffuse, finish->diffuse_back,
                         surface->at->leaf->look->double_illuminate);
}

rgb surface_returned(const struct surface *surface)
{
    return albedo_bounded(surface_scattered(surface),
                          surface_returned_most(surface));
}
