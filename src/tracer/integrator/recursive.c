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
#include <string.h>

#include "base/draw.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/telling.h"
#include "scene/lens.h"
#include "shade/finish.h"
#include "shade/interior.h"
#include "shade/media.h"
#include "shade/rainbow.h"
#include "shade/shadow.h"
#include "shade/spectrum.h"
#include "shade/background.h"
#include "tracer/crossing.h"
#include "tracer/integrator.h"
#include "tracer/photons.h"
#include "tracer/subsurface.h"

enum {
    SURFACES_MAX = 1000 * 1000, /* a ray passes straight through */
    BLUR_LEAST = 4,             /* rays through a lens, for a variance */
};

/* A ray on its way, and what it has gathered. */
struct path {
    const struct tracer *tracer;
    struct worker *worker;
    struct ray ray;
    enum ray_kind kind;
    int level;     /* 1 for camera rays */
    double weight; /* in the pixel, for adc_bailout */
    bool straight; /* the camera's line of sight: its opacity counts */
    struct interiors inside;
    const struct picture_place *place; /* of a camera ray that has met nothing
                                        * yet; else NULL */

    rgb share;    /* of what the ray meets next, in its radiance */
    double clear; /* 1 - opacity so far */
    rgb light;    /* gathered */
};

/* Mirrors recurse: that they do so on the stack of a thread bounds their depth.
 * What is asked at a surface has as much again, and more. */
_Static_assert(4 * SETTINGS_LEVELS_MAX *
                       (sizeof(struct path) + sizeof(struct crossing)) <
                   PARALLEL_STACK,
               "max_trace_level fits into the stack");

static struct radiance path_follow(struct path *path);

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

/* The light that the surface itself sends to the viewer. */
static rgb path_shade(const struct path *path, struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct surface *surface = &crossing->surface;
    rgb within = subsurface_light(tracer, path->worker, path->kind, crossing);
    struct gathering gathering = { surface, within };
    struct diffuse_light diffuse =
        tracer->lighting->illuminate(tracer->lighting_state, path->worker,
                                     surface, gather_sample, &gathering);
    photons_light(tracer, path->worker, surface, gather_sample, &gathering);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb glow = finish_glow(layer, diffuse.ambient, diffuse.irradiance);
        glow = rgb_add(glow, finish_shine(layer));
        gathering.light =
            rgb_add(gathering.light, rgb_mul(layer->weight, glow));
    }
    return gathering.light;
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

/* At the surface: returns false if the ray ends here. */
static bool path_cross(struct path *path, struct crossing *crossing)
{
    const struct tracer *tracer = path->tracer;
    const struct settings *settings = &tracer->scene->settings;
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
    rgb light = path_shade(path, crossing);
    if (path->worker->telling)
        path_tell_light(path, light);
    path_gather(path, light);
    return path->level < tracer_levels(tracer) && path_pass(path, crossing);
}

static bool path_meet(struct path *path, struct intersection *at)
{
    return world_closest(path->tracer->world, &path->ray,
                         surface_offset(path->ray.origin), path->kind, at);
}

/* Follows the ray to its end, from what it meets first, which is known. */
static struct radiance path_go_on(struct path *path, struct crossing *crossing,
                                  bool met)
{
    const struct tracer *tracer = path->tracer;
    path->share = rgb_grey(1);
    path->clear = 1;
    path->light = rgb_grey(0);
    for (int i = 0; i < SURFACES_MAX; i++) {
        if (worker_stopped(path->worker))
            break;
        path_air(path, met ? crossing->at.t : (double)INFINITY);
        if (!met) {
            double clear;
            path_gather(path, tracer_background(tracer, path->ray.direction,
                                                path->straight, &clear));
            return (struct radiance){ path->light, 1 - path->clear * clear };
        }
        if (!path_cross(path, crossing))
            break;
        met = path_meet(path, &crossing->at);
    }
    return (struct radiance){ path->light, 1 };
}

static struct radiance path_follow(struct path *path)
{
    struct crossing crossing;
    bool met = path_meet(path, &crossing.at);
    return path_go_on(path, &crossing, met);
}

static void path_start(struct path *path, const struct tracer *tracer,
                       struct worker *worker, const struct picture_place *place,
                       const struct ray *ray)
{
    path->tracer = tracer;
    path->worker = worker;
    path->ray = *ray;
    path->place = place;
    path->kind = RAY_CAMERA;
    path->level = 1;
    path->weight = 1;
    path->straight = true;
    tracer_enter(tracer, worker, path->ray.origin, &path->inside);
}

/* Rays through the lens, and their squares. */
struct blur {
    rgb sum, squares;
    double opacity;
    int count;
};

static void blur_add(struct blur *blur, struct radiance seen)
{
    blur->sum = rgb_add(blur->sum, seen.colour);
    blur->squares = rgb_add(blur->squares, rgb_mul(seen.colour, seen.colour));
    blur->opacity += seen.opacity;
    blur->count++;
}

static struct radiance blur_mean(const struct blur *blur)
{
    double share = blur->count ? 1.0 / blur->count : 0;
    return (struct radiance){ rgb_scale(blur->sum, share),
                              blur->opacity * share };
}

/* Whether the mean's variance is, with the confidence asked for, small enough.
 * The logistic distribution stands for the normal one. */
static bool blur_settled(const struct blur *blur, const struct camera *camera)
{
    double n = blur->count;
    double sure = fmin(fmax(camera->confidence, 0), 0.999999);
    double width = log((1 + sure) / (1 - sure)) / 1.702;
    rgb mean = rgb_scale(blur->sum, 1 / n);
    rgb spread = rgb_sub(rgb_scale(blur->squares, 1 / n), rgb_mul(mean, mean));
    return n >= BLUR_LEAST && n >= camera->blur_samples[0] &&
           rgb_peak(spread) * width * width <= n * camera->variance;
}

/* Each ray is of another place of the pixel, whatever antialiasing does beside
 * it (measured). */
static void blur_spread(const struct camera *camera, struct draws draws,
                        double at[2])
{
    draw_pair(&draws, 0, at);
    for (int i = 0; i < 2; i++)
        at[i] = camera->pixels[i] > 0 ? (at[i] - 0.5) / camera->pixels[i] : 0;
}

static struct radiance tracer_blurred(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    double x = place->at[0], y = place->at[1];
    int most = (int)camera->blur_samples[1];
    struct blur blur = { .count = 0 };
    uint64_t bits[2];
    memcpy(bits, (const double[]){ x, y }, sizeof bits);
    uint64_t key = random_key(bits[0], bits[1]);
    for (int i = 0; i < most && !worker_stopped(worker); i++) {
        struct path path;
        double lens[2], at[2];
        blur_spread(camera, (struct draws){ key, (uint32_t)i }, at);
        lens_point(most, i, key, lens);
        struct ray ray = camera_lens_ray(camera, x + at[0], y + at[1], lens);
        path_start(&path, tracer, worker, NULL, &ray);
        blur_add(&blur, path_follow(&path));
        arena_reset(worker->scratch);
        if (blur_settled(&blur, camera))
            break;
    }
    return blur_mean(&blur);
}

/* The mean of the pixel's rays; those that lead nowhere don't count. */
static struct radiance tracer_several(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    struct blur blur = { .count = 0 };
    for (int i = 0; i < camera->rays && !worker_stopped(worker); i++) {
        struct path path;
        struct ray ray;
        if (!camera_pixel_ray(camera, place->at[0], place->at[1], i, &ray))
            continue;
        path_start(&path, tracer, worker, NULL, &ray);
        blur_add(&blur, path_follow(&path));
        arena_reset(worker->scratch);
    }
    return blur_mean(&blur);
}

struct radiance tracer_camera(const struct tracer *tracer,
                              struct worker *worker,
                              const struct picture_place *place)
{
    struct path path;
    const struct camera *camera = &tracer->scene->camera;
    if (!camera_sees(camera, place->at[0], place->at[1]))
        return (struct radiance){ rgb_grey(0), 0 };
    if (camera_blurs(camera))
        return tracer_blurred(tracer, worker, place);
    if (camera->rays > 1)
        return tracer_several(tracer, worker, place);
    struct ray ray = camera_ray(camera, place->at[0], place->at[1]);
    path_start(&path, tracer, worker, place, &ray);
    return path_follow(&path);
}

struct ray tracer_ray(const struct tracer *tracer,
                      const struct picture_place *place)
{
    return camera_ray(&tracer->scene->camera, place->at[0], place->at[1]);
}

void tracer_meet_many(const struct tracer *tracer, const struct ray *rays,
                      unsigned count, struct world_hit *hits)
{
    double offsets[WORLD_RAYS];
    for (unsigned i = 0; i < count; i++)
        offsets[i] = surface_offset(rays[i].origin);
    world_closest_many(tracer->world, rays, offsets, count, RAY_CAMERA, hits);
}

void tracer_see_many(const struct tracer *tracer, struct worker *worker,
                     const struct tracer_met *met, struct radiance *out)
{
    const struct camera *camera = &tracer->scene->camera;
    bool single = camera->rays <= 1 && !camera_blurs(camera);
    for (unsigned i = 0; i < met->count; i++) {
        const struct picture_place *place = &met->places[i];
        const struct world_hit *hit = &met->hits[i];
        struct path path;
        struct crossing crossing;
        if (!single) {
            out[i] = tracer_camera(tracer, worker, place);
            continue;
        }
        out[i] = (struct radiance){ rgb_grey(0), 0 };
        if (!camera_sees(camera, place->at[0], place->at[1]))
            continue;
        path_start(&path, tracer, worker, place, &met->rays[i]);
        if (hit->leaf)
            world_describe(&path.ray, hit, &crossing.at);
        out[i] = path_go_on(&path, &crossing, hit->leaf);
        arena_reset(worker->scratch);
    }
}

const struct integrator recursive_integrator = { .name = "recursive" };
