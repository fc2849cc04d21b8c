/* The finish: how much of the light that reaches a layer of paint goes to the
 * viewer. Formulas of section 5 of tests/povray.md, measured on POV-Ray 3.7. */
#ifndef SHADE_FINISH_H
#define SHADE_FINISH_H

#include "base/lesser.h"
#include "base/power.h"
#include "shade/surface.h"

/* Adds what the surface's layers send to the viewer of light of one direction:
 * diffuse, phong and specular. */
void surface_add_light(const struct surface *surface,
                       const struct light_sample *sample, rgb *sum);

/* What white paint that is so opaque sends of light, without highlights: by
 * Lambert's law, brilliance and crand. `point`: where, in the world. */
double finish_diffused(const struct finish *finish,
                       const struct finish_meeting *meeting, vec3 point,
                       bool twice, double opacity);

/* What takes the place of the cosine of light that comes to a surface's front,
 * which Lambert's law has: cosine^brilliance, and `diffuse albedo` makes the
 * whole reflected share `diffuse`. */
static inline double finish_cosine(const struct finish *finish, double cosine)
{
    if (finish->brilliance == 1)
        return cosine;
    double facing = power_of(cosine, finish->brilliance);
    return finish->diffuse_albedo ? facing * (finish->brilliance + 1) / 2
                                  : facing;
}

/* How much light that comes from all around counts, beside what it does by
 * Lambert's law: the mean of finish_cosine over that of the cosine. */
static inline double finish_around(const struct finish *finish)
{
    bool lambert = finish->brilliance == 1 || finish->diffuse_albedo;
    return lambert ? 1 : 2 / (fmax(finish->brilliance, 0) + 1);
}

/* Whether that is more than the cosine times a number. */
static inline bool finish_is_uneven(const struct finish *finish)
{
    return finish->brilliance != 1 || finish->crand > 0;
}

/* The part of a layer that is no pane. In scenes before version 3.7 a filter
 * takes from the surface's own light only what its brightest colour lets
 * through (measured). */
static inline double finish_opacity(const struct finish *finish, colour c)
{
    double peak = finish->old_filter ? greater(c.r, greater(c.g, c.b)) : 1;
    return 1 - c.filter * peak - c.transmit;
}

static inline double layer_opacity(const struct surface_layer *layer)
{
    return finish_opacity(layer->finish, layer->pigment);
}

/* What white paint makes of light without a direction. */
static inline rgb finish_given(const struct finish *finish, rgb ambient,
                               rgb irradiance)
{
    rgb light = rgb_mul(finish->ambient, ambient);
    light = rgb_add(light, finish->emission);
    return rgb_add_scaled(light, irradiance, finish->diffuse);
}

/* What one layer makes of light without a direction: ambient, emission, and
 * irradiance (Lambert is diffuse * pigment * irradiance). The layer's weight is
 * not applied. */
rgb finish_glow(const struct surface_layer *layer, rgb ambient, rgb irradiance);

/* What the layer makes of ambient light 1. Likewise. */
rgb finish_ambient(const struct surface_layer *layer);

/* Light of its own that the layer shows its viewer and that lights nothing
 * else: ambient light that is meant to glow. Likewise. */
rgb finish_shine(const struct surface_layer *layer);

/* The light that a surface itself sends to all others: emission. */
rgb surface_glow(const struct surface *surface);

/* The sum of finish_shine. */
rgb surface_shine(const struct surface *surface);

/* No more than that. */
static inline rgb albedo_bounded(rgb albedo, double most)
{
    double peak = rgb_peak(albedo);
    return peak > most ? rgb_scale(albedo, most / peak) : albedo;
}

/* What it sends back of irradiance, without highlights and mirrors: never all
 * of it. */
rgb surface_albedo(const struct surface *surface);

/* How much of that goes on to other surfaces, which get no more than
 * `returned_most` of its layers allows: a factor, at most 1. */
double surface_restraint(const struct surface *surface);

/* How much of light from behind is sent to the viewer, of light from the
 * front: `diffuse`'s second number over the first. */
static inline double finish_behind(double diffuse, double back, bool twice)
{
    return twice ? 1 : diffuse != 0 ? back / diffuse : 0;
}

/* That of the outermost layer. */
double surface_behind(const struct surface *surface);

/* What they get of irradiance. */
rgb surface_returned(const struct surface *surface);

/* What goes through it on to other surfaces: a pane whose `transmit` says that
 * it lets more pass than there is, or less than nothing, is a trick for the eye
 * of the camera. */
static inline rgb surface_passed(const struct surface *surface)
{
    rgb through = surface->through;
    return rgb_make(fmin(fmax(through.r, 0), 1), fmin(fmax(through.g, 0), 1),
                    fmin(fmax(through.b, 0), 1));
}

/* Whether light that meets the layer at this cosine (negative: from behind)
 * does anything. `twice`: the object says double_illuminate. */
static inline bool finish_lit_by(const struct finish *finish, double cosine,
                                 bool twice)
{
    if (cosine > 0 || twice)
        return finish->diffuse != 0 || finish_shines(finish);
    return cosine < 0 && finish->diffuse_back != 0;
}

struct finish_mirror {
    rgb colour;    /* multiplies the mirrored light */
    rgb kept;      /* from what passes, with conserve_energy: the same without
                    * the film that tints what is mirrored (measured) */
    double weight; /* of the ray that looks there, before any tint */
};

/* The mirror for a viewer at `cosine` from the normal (negative: a bump faces
 * away). `ior` is that of the medium behind the surface over that in front. */
struct finish_mirror finish_mirror(const struct finish *finish, rgb pigment,
                                   double cosine, double ior);

/* The mirrored direction, unit, for the normal of a surface's layer and that of
 * the surface, which is turned to the viewer. It never goes into the
 * surface: what would is mirrored back by the true surface, and where the bump
 * faces away from the viewer that alone mirrors (measured). Part of its
 * callers, whose vectors were mostly only just made: see path_gather. */
INLINED vec3 surface_mirrored(vec3 surface, vec3 direction, vec3 normal)
{
    double cosine = vec3_dot(direction, normal);
    vec3 mirrored = vec3_along(direction, normal, -2 * cosine);
    double rise = vec3_dot(mirrored, surface);
    if (rise < 0 && cosine < 0)
        mirrored = vec3_along(mirrored, surface, -2 * rise);
    else if (rise < 0)
        mirrored =
            vec3_along(direction, surface, -2 * vec3_dot(direction, surface));
    return vec3_normalise(mirrored);
}

/* What mirrored light becomes under reflection exponent E: light^(1/E). */
rgb finish_raised(rgb light, double exponent);

/* The mirror of paint there, tints and all; `view` is unit, to the viewer. */
static inline struct finish_mirror
finish_mirror_seen(const struct surface_paint *paint, vec3 view, double ior)
{
    const struct finish *finish = paint->finish;
    if (!finish_mirrors(finish))
        return (struct finish_mirror){ rgb_grey(0), rgb_grey(0), 0 };
    double cosine = vec3_dot(view, paint->bumped);
    struct finish_mirror mirror =
        finish_mirror(finish, colour_rgb(paint->pigment), cosine, ior);
    if (finish_tints(finish)) {
        vec3 from =
            surface_mirrored(paint->normal, vec3_negate(view), paint->bumped);
        rgb tint = finish_tint(finish, paint->point,
                               vec3_dot(from, paint->bumped), cosine);
        /* It tints what the exponent is applied to (measured). */
        if (finish->reflection.exponent != 1)
            tint = finish_raised(tint, finish->reflection.exponent);
        mirror.colour = rgb_mul(mirror.colour, tint);
    }
    return mirror;
}

/* What light passes a layer down to the next. */
static inline rgb finish_through(const struct finish *finish, colour pigment,
                                 const struct finish_mirror *mirror)
{
    rgb through = colour_transmittance(pigment);
    if (finish->conserve_energy)
        through = rgb_mul(through, rgb_sub(rgb_grey(1), mirror->kept));
    return through;
}

/* Reflectance of a dielectric for unpolarised light (Fresnel); 1 in total
 * internal reflection. */
double finish_fresnel(double cosine, double ior);

/* The tint of metallic highlights and mirrors: white at grazing angles, the
 * pigment at normal incidence, `metallic` of the way there. `cosine` may be
 * negative: light from behind. */
rgb finish_metallic(double metallic, double cosine, rgb pigment);

/* Highlights that are such a share of a lamp's light, with the colour that they
 * have on this paint. `cosine` of the light to the layer's normal. */
static inline rgb finish_highlights_tinted(const struct finish *finish,
                                           double share, rgb pigment,
                                           double cosine)
{
    if (finish->metallic == 0)
        return rgb_grey(share);
    return rgb_scale(finish_metallic(finish->metallic, cosine, pigment), share);
}

/* Finish_raised; most of the time light stays what it is. */
static inline rgb finish_exponent(rgb light, double exponent)
{
    return exponent == 1 || exponent <= 0 ? light
                                          : finish_raised(light, exponent);
}

#endif
