/* Whitted's recursion with POV-Ray's rules, measured on POV-Ray 3.7:
 * - A surface sends rays on only while its level is below max_trace_level.
 *   Mirrored and refracted rays are one level up; what passes straight through
 *   stays on the level, so panes of glass are never too many. Nothing here
 *   recurses: what branches off waits in a wavefront (tracer/wavefront.h).
 * - A ray that weighs less than adc_bailout is not traced: its weight is the
 *   product of the largest components of mirrors and filters on its way, and
 *   of the brightness of layers above a mirror. What passes one surface must
 *   also be as bright as that by itself.
 * - Total reflection takes the place of all that is transmitted and mirrored,
 *   at full weight.
 * - Fading in an interior weakens what passes where the ray leaves it. */
#include "base/telling.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/interior.h"
#include "shade/media.h"
#include "shade/rainbow.h"
#include "shade/shadow.h"
#include "shade/spectrum.h"
#include "tracer/branch.h"
#include "tracer/integrator.h"
#include "tracer/photons.h"
#include "tracer/wavefront.h"
#include "tracer/subsurface.h"

/* Something half transparent on the way. */
static void path_veil(struct path *path, const struct veil *veil)
{
    path_gather(path, veil->light);
    path->share = rgb_mul(path->share, veil->through);
    path->clear *= rgb_brightness(veil->through);
}

static void path_media(struct path *path, double distance,
                       const struct leaf *end)
{
    const struct tracer *tracer = path->tracer;
    struct media_list media;
    media_find(&media, &tracer->scene->media, &path->inside);
    if (media.count == 0)
        return;
    struct media_way way = {
        .media = &media,
        .origin = path->ray.origin,
        .direction = path->ray.direction,
        .length = distance,
        .end = end,
        .lamps = tracer->lighting->lamps(tracer->lighting_state),
        .photons = tracer->photons ? photon_map_within(tracer->photons) : NULL,
        .worker = path->worker,
        .inside = &path->inside,
    };
    struct veil veil = media_veil(&way);
    path_veil(path, &veil);
}

/* Fog is before the media (measured). */
void path_air(struct path *path, double distance, const struct leaf *end,
              const struct veil *fog)
{
    const struct tracer *tracer = path->tracer;
    if (fog) {
        path_veil(path, fog);
    } else if (tracer_foggy(tracer, &path->inside)) {
        struct veil veil = fog_veil(tracer->scene, &path->ray, distance);
        path_veil(path, &veil);
    }
    if (tracer_arched(tracer, &path->inside)) {
        struct veil veil = rainbow_veil(tracer->scene, &path->ray, distance);
        path_veil(path, &veil);
    }
    if (tracer_misty(tracer))
        path_media(path, distance, end);
}

/* Sums the light of all lamps over the layers. */
struct gathering {
    const struct surface *surface;
    rgb light;
};

static void gather_sample(void *context, const struct light_sample *sample)
{
    struct gathering *gathering = context;
    surface_add_light(gathering->surface, sample, &gathering->light);
}

rgb path_within(const struct path *path, struct crossing *crossing)
{
    return subsurface_happens(path->tracer, crossing)
               ? subsurface_light(path->tracer, path->worker, path->kind,
                                  crossing)
               : rgb_grey(0);
}

rgb path_shade(const struct path *path, const struct crossing *crossing,
               rgb light, const struct diffuse_light *diffuse)
{
    const struct surface *surface = &crossing->surface;
    struct gathering gathering = { surface, light };
    if (path->tracer->photons)
        photons_light(path->tracer, path->worker, surface, gather_sample,
                      &gathering);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb glow = finish_glow(layer, diffuse->ambient, diffuse->irradiance);
        glow = rgb_add(glow, finish_shine(layer));
        gathering.light =
            rgb_add(gathering.light, rgb_mul(layer->weight, glow));
    }
    return gathering.light;
}

rgb path_light(const struct path *path, struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct surface *surface = &crossing->surface;
    struct gathering gathering = { surface, path_within(path, crossing) };
    struct diffuse_light diffuse =
        tracer->lighting->illuminate(tracer->lighting_state, path->worker,
                                     surface, gather_sample, &gathering);
    return path_shade(path, crossing, gathering.light, &diffuse);
}

/* Another ray from that point, which is as bright as it is tinted. */
static struct path *path_branch(struct path *path, vec3 origin, rgb tint,
                                double weight)
{
    struct path *branch = wavefront_branch(path, tint);
    branch->ray.origin = origin;
    branch->kind = path->kind;
    branch->level = path->level + 1;
    branch->weight = weight;
    interiors_copy(&branch->inside, &path->inside);
    path->worker->counters.secondary_rays++;
    return branch;
}

/* One layer's mirror, seen by a ray of that weight. */
struct layer_mirror {
    const struct finish *finish;
    vec3 point, direction;
    rgb tint;
    double weight;
};

static void path_mirror(struct path *path, const struct layer_mirror *mirror)
{
    struct path *branch =
        path_branch(path, mirror->point, mirror->tint, mirror->weight);
    branch->ray.direction = mirror->direction;
    branch->kind = RAY_REFLECTION;
    branch->due->exponent = mirror->finish->reflection.exponent;
}

/* Whether a mirror is worth a ray of that weight. */
static bool path_is_worth(const struct path *path, double weight)
{
    return weight > 0 && weight >= path->tracer->scene->settings.adc_bailout;
}

static void path_mirrors(struct path *path, const struct crossing *crossing)
{
    const struct surface *surface = &crossing->surface;
    if (path->tracer->quality < QUALITY_REFLECTION)
        return;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double weight = path->weight * rgb_brightness(layer->weight) *
                        layer->reflection_weight;
        if (!path_is_worth(path, weight))
            continue;
        const struct layer_mirror mirror = {
            .finish = layer->finish,
            .point = crossing->at.point,
            .direction = surface_mirrored(surface->normal, path->ray.direction,
                                          layer->normal),
            .tint = layer->reflection,
            .weight = weight,
        };
        path_mirror(path, &mirror);
    }
}

void path_leave_plain(struct path *path, const struct leaf *leaf,
                      const struct surface_paint *paint, rgb light)
{
    const struct finish *finish = paint->finish;
    const struct tracer *tracer = path->tracer;
    vec3 direction = path->ray.direction;
    path_gather(path, light);
    if (path->level >= tracer_levels(tracer) ||
        tracer->quality < QUALITY_REFLECTION || !finish_mirrors(finish))
        return;
    double ior = finish->reflection.fresnel
                     ? crossing_plain_ior(leaf, &path->inside)
                     : 1;
    struct finish_mirror mirrored =
        finish_mirror_seen(paint, vec3_negate(direction), ior);
    double weight = path->weight * mirrored.weight;
    if (!path_is_worth(path, weight))
        return;
    const struct layer_mirror mirror = {
        .finish = finish,
        .point = paint->point,
        .direction = surface_mirrored(paint->normal, direction, paint->bumped),
        .tint = mirrored.colour,
        .weight = weight,
    };
    path_mirror(path, &mirror);
}

static void path_fade(struct path *path, const struct crossing *crossing)
{
    if (crossing->leaving)
        path->share = rgb_mul(
            path->share,
            interior_fade(crossing->at.leaf->look->interior, crossing->at.t));
}

/* One colour of the light that passes, which is bent its own way. */
static void path_part(struct path *path, const struct crossing *crossing,
                      int number, int parts)
{
    rgb part = spectrum_part(number, parts);
    rgb through = crossing->surface.through;
    double weight = path->weight * rgb_peak(through) * rgb_peak(part);
    if (weight < path->tracer->scene->settings.adc_bailout)
        return;
    struct crossing own = *crossing;
    struct path *branch = path_branch(path, crossing->at.point, part, weight);
    vec3 normal = crossing->surface.pane;
    crossing_divide(&own, &branch->inside, spectrum_place(number, parts));
    if (crossing_refracted(&own, path->ray.direction, normal,
                           &branch->ray.direction)) {
        branch->due->tint = rgb_mul(part, through);
        interiors_copy(&branch->inside, &own.beyond);
    } else {
        branch->ray.direction =
            surface_mirrored(own.surface.normal, path->ray.direction, normal);
    }
}

/* Goes on behind the surface, or inside it after total reflection. Returns
 * false if the ray ends here. */
static bool path_pass(struct path *path, const struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct surface *surface = &crossing->surface;
    rgb through = surface->through;
    double bailout = tracer->scene->settings.adc_bailout;
    double weight = path->weight * rgb_peak(through);
    vec3 normal = surface->pane;
    vec3 direction = path->ray.direction;
    bool bends = crossing->ior != 1, inward = false;
    if (tracer->quality < QUALITY_TRANSPARENCY || rgb_peak(through) == 0 ||
        fabs(rgb_brightness(through)) < bailout || weight < bailout) {
        path_mirrors(path, crossing);
        return false;
    }
    int parts = bends ? crossing_parts(crossing, &path->inside) : 1;
    if (parts > 1) {
        path_mirrors(path, crossing);
        path_fade(path, crossing);
        for (int i = 0; i < parts; i++)
            path_part(path, crossing, i, parts);
        return false;
    }
    if (bends)
        inward = !crossing_refracted(crossing, path->ray.direction, normal,
                                     &direction);
    if (inward) {
        direction =
            surface_mirrored(surface->normal, path->ray.direction, normal);
        path->straight = false;
        path->clear = 0;
    } else {
        path_mirrors(path, crossing);
        path->share = rgb_mul(path->share, through);
        path->clear *= rgb_brightness(through);
        interiors_copy(&path->inside, &crossing->beyond);
    }
    path->weight = weight; /* where it is all sent back, too (measured) */
    path_fade(path, crossing);
    path->ray = (struct ray){ crossing->at.point, direction };
    path->level += bends;
    path->worker->counters.secondary_rays++;
    return true;
}

/* For --debug-pixel. */
static void path_tell_meeting(const struct path *path,
                              const struct intersection *at)
{
    struct telling *telling = path->worker->telling;
    const struct span *span = &at->leaf->object->span;
    unsigned line = 0;
    if (span->source)
        line = source_locate(span->source, span->offset).line;
    telling->depth = path->level;
    telling_say(telling, "%s:%u: <%.4g, %.4g, %.4g>, %.3g of the pixel",
                span->source ? span->source->name : "", line, at->point.x,
                at->point.y, at->point.z, path->weight);
    telling->depth++;
}

static void path_tell_light(const struct path *path, rgb light)
{
    telling_say(path->worker->telling, "sends %.4g %.4g %.4g", light.r, light.g,
                light.b);
}

bool path_arrive(struct path *path, struct crossing *crossing,
                 const struct veil *sky, const struct veil *fog)
{
    const struct tracer *tracer = path->tracer;
    const struct settings *settings = &tracer->scene->settings;
    path_air(path, sky ? (double)INFINITY : crossing->at.t,
             sky ? NULL : crossing->at.leaf, fog);
    if (sky) {
        double clear;
        path_gather(path, tracer_beyond(tracer, sky, path->straight, &clear));
        path->opacity = 1 - path->clear * clear;
        return false;
    }
    crossing_fill(crossing, tracer, path->ray.direction, &path->inside,
                  settings->adc_bailout, false);
    crossing->surface.place = path->place;
    crossing->surface.unmirrored = path->straight;
    crossing->surface.weight = path->weight;
    path_passes(path, crossing->at.leaf);
    if (tracer->quality < QUALITY_LIT) {
        path_gather(path, colour_rgb(crossing->surface.layer[0].pigment));
        return false;
    }
    if (path->worker->telling)
        path_tell_meeting(path, &crossing->at);
    return true;
}

bool path_leave(struct path *path, const struct crossing *crossing, rgb light)
{
    if (path->worker->telling)
        path_tell_light(path, light);
    path_gather(path, light);
    return path->level < tracer_levels(path->tracer) &&
           path_pass(path, crossing);
}

bool path_meet(struct path *path, struct intersection *at)
{
    return world_closest(path->tracer->world, &path->ray,
                         surface_offset(path->ray.origin), path->kind, at);
}

void path_start(struct path *path, const struct picture_place *place)
{
    path->place = place;
    path->kind = RAY_CAMERA;
    path->level = 1;
    path->weight = 1;
    path->straight = true;
    tracer_enter(path->tracer, path->worker, path->ray.origin, &path->inside);
}

const struct integrator recursive_integrator = { .name = "recursive" };
