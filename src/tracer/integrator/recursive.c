/* Whitted's recursion with POV-Ray's rules, measured on POV-Ray 3.7:
 * - A surface sends rays on only while its level is below max_trace_level.
 *   Mirrored and refracted rays are one level up; what passes straight through
 *   stays on the level, so panes of glass are never too many. It is followed
 *   in a loop, not by recursion: the stack is bounded by the level.
 * - A ray that weighs less than adc_bailout is not traced: its weight is the
 *   product of the largest components of mirrors and filters on its way, and
 *   of the brightness of layers above a mirror. What passes one surface must
 *   also be as bright as that by itself.
 * - Total reflection takes the place of all that is transmitted and mirrored,
 *   at full weight.
 * - Fading in an interior weakens what passes where the ray leaves it. */
#include "base/parallel.h"
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
#include "tracer/subsurface.h"

enum {
    SURFACES_MAX = 1000 * 1000, /* a ray passes straight through */
};

/* Mirrors recurse: that they do so on the stack of a thread bounds their depth.
 * What is asked at a surface has as much again, and more. */
_Static_assert(4 * SETTINGS_LEVELS_MAX *
                       (sizeof(struct path) + sizeof(struct crossing)) <
                   PARALLEL_STACK,
               "max_trace_level fits into the stack");

static void path_gather(struct path *path, rgb light)
{
    path->light = rgb_add(path->light, rgb_mul(path->share, light));
}

/* Something half transparent on the way. */
static void path_veil(struct path *path, const struct veil *veil)
{
    path_gather(path, veil->light);
    path->share = rgb_mul(path->share, veil->through);
    path->clear *= rgb_brightness(veil->through);
}

static void path_media(struct path *path, double distance)
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
        .lamps = tracer->lighting->lamps(tracer->lighting_state),
        .worker = path->worker,
        .inside = &path->inside,
    };
    struct veil veil = media_veil(&way);
    path_veil(path, &veil);
}

/* Fog is before the media (measured). */
static void path_air(struct path *path, double distance)
{
    const struct tracer *tracer = path->tracer;
    if (tracer_foggy(tracer, &path->inside)) {
        struct veil veil = fog_veil(tracer->scene, &path->ray, distance);
        path_veil(path, &veil);
    }
    if (tracer_arched(tracer, &path->inside)) {
        struct veil veil = rainbow_veil(tracer->scene, &path->ray, distance);
        path_veil(path, &veil);
    }
    if (tracer_misty(tracer))
        path_media(path, distance);
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

static rgb path_light(const struct path *path, struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct surface *surface = &crossing->surface;
    struct gathering gathering = { surface, path_within(path, crossing) };
    struct diffuse_light diffuse =
        tracer->lighting->illuminate(tracer->lighting_state, path->worker,
                                     surface, gather_sample, &gathering);
    return path_shade(path, crossing, gathering.light, &diffuse);
}

/* One layer's mirror. */
static rgb path_mirror(const struct path *path, const struct crossing *crossing,
                       const struct surface_layer *layer, double weight)
{
    struct path branch;
    branch.tracer = path->tracer;
    branch.worker = path->worker;
    branch.ray.origin = crossing->at.point;
    branch.ray.direction =
        crossing_mirrored(crossing, path->ray.direction, layer->normal);
    branch.kind = RAY_REFLECTION;
    branch.level = path->level + 1;
    branch.weight = weight;
    branch.straight = false;
    branch.place = NULL;
    interiors_copy(&branch.inside, &path->inside);
    path->worker->counters.secondary_rays++;
    rgb light = path_follow(&branch).colour;
    light = finish_exponent(light, layer->finish->reflection.exponent);
    return rgb_mul(light, layer->reflection);
}

static void path_mirrors(struct path *path, const struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct surface *surface = &crossing->surface;
    if (tracer->quality < QUALITY_REFLECTION)
        return;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double weight = path->weight * rgb_brightness(layer->weight) *
                        layer->reflection_weight;
        if (weight > 0 && weight >= tracer->scene->settings.adc_bailout)
            path_gather(path, path_mirror(path, crossing, layer, weight));
    }
}

static void path_fade(struct path *path, const struct crossing *crossing)
{
    if (crossing->leaving)
        path->share =
            rgb_mul(path->share,
                    interior_fade(crossing->at.leaf->interior, crossing->at.t));
}

/* One colour of the light that passes, which is bent its own way. */
static void path_part(struct path *path, const struct crossing *crossing,
                      int number, int parts)
{
    rgb part = spectrum_part(number, parts);
    struct crossing own = *crossing;
    struct path branch = *path;
    branch.weight =
        path->weight * rgb_peak(crossing->surface.through) * rgb_peak(part);
    if (branch.weight < path->tracer->scene->settings.adc_bailout)
        return;
    vec3 normal = crossing->surface.layer[0].normal;
    crossing_divide(&own, &branch.inside, spectrum_place(number, parts));
    if (crossing_refracted(&own, path->ray.direction, normal,
                           &branch.ray.direction)) {
        part = rgb_mul(part, crossing->surface.through);
        interiors_copy(&branch.inside, &own.beyond);
    } else {
        branch.ray.direction =
            crossing_mirrored(&own, path->ray.direction, normal);
    }
    branch.ray.origin = crossing->at.point;
    branch.level++;
    branch.straight = false;
    path->worker->counters.secondary_rays++;
    path_gather(path, rgb_mul(part, path_follow(&branch).colour));
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
    vec3 normal = surface->layer[0].normal;
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
        direction = crossing_mirrored(crossing, path->ray.direction, normal);
        path->straight = false;
        path->clear = 0;
    } else {
        path_mirrors(path, crossing);
        path->share = rgb_mul(path->share, through);
        path->clear *= rgb_brightness(through);
        path->weight = weight;
        interiors_copy(&path->inside, &crossing->beyond);
    }
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

bool path_arrive(struct path *path, struct crossing *crossing, bool met)
{
    const struct tracer *tracer = path->tracer;
    const struct settings *settings = &tracer->scene->settings;
    path_air(path, met ? crossing->at.t : (double)INFINITY);
    if (!met) {
        double clear;
        path_gather(path, tracer_background(tracer, path->ray.direction,
                                            path->straight, &clear));
        path->opacity = 1 - path->clear * clear;
        return false;
    }
    crossing_fill(crossing, tracer, path->ray.direction, &path->inside,
                  settings->adc_bailout, false);
    crossing->surface.place = path->place;
    crossing->surface.weight = path->weight;
    path->place = NULL;
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

static void path_begin(struct path *path)
{
    path->share = rgb_grey(1);
    path->clear = 1;
    path->light = rgb_grey(0);
    path->opacity = 1;
}

struct radiance path_go_on(struct path *path, struct crossing *crossing,
                           bool met)
{
    for (int i = 0; i < SURFACES_MAX; i++) {
        if (worker_stopped(path->worker) || !path_arrive(path, crossing, met) ||
            !path_leave(path, crossing, path_light(path, crossing)))
            break;
        met = path_meet(path, &crossing->at);
    }
    return path_seen(path);
}

struct radiance path_follow(struct path *path)
{
    struct crossing crossing;
    path_begin(path);
    bool met = path_meet(path, &crossing.at);
    return path_go_on(path, &crossing, met);
}

void path_start(struct path *path, const struct tracer *tracer,
                struct worker *worker, const struct picture_place *place)
{
    path->tracer = tracer;
    path->worker = worker;
    path->place = place;
    path->kind = RAY_CAMERA;
    path->level = 1;
    path->weight = 1;
    path->straight = true;
    path_begin(path);
    tracer_enter(tracer, worker, path->ray.origin, &path->inside);
}

const struct integrator recursive_integrator = { .name = "recursive" };
