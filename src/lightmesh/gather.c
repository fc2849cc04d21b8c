/* Gather rays: see gather.h. */
#include "lightmesh/gathering.h"

#include "lightmesh/gather_paint.h"
#include "lightmesh/tuning.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* So much of what it met is open to ambient light. */
static void gathering_opens(struct gathering *gathering, double open)
{
    double share = rgb_brightness(gathering->share);
    if (!gathering->gather->ambience->sky)
        *gathering->open += open * share;
}

/* Fog on the way over `distance`: it weakens what is behind, and is as much sky
 * as it hides. */
static void gathering_fog(struct gathering *gathering, double distance,
                          rgb *light)
{
    const struct ambience *ambience = gathering->gather->ambience;
    if (ambience->scene->fogs.count == 0)
        return;
    struct veil veil = fog_veil(ambience->scene, &gathering->ray, distance);
    if (ambience->sky)
        *light = rgb_add(*light, rgb_mul(gathering->share, veil.light));
    gathering_opens(gathering, 1 - rgb_brightness(veil.through));
    gathering->share = rgb_mul(gathering->share, veil.through);
}

/* What counts little is looked at by few rays, for which it counts the more
 * (Russian roulette, Arvo and Kirk 1990). Returns by how much; 0: not by this
 * one. */
static double gathering_chance(const struct gathering *gathering, double chance,
                               uint32_t slot)
{
    bool taken = chance >= 1 || draw_unit(gathering->draws, slot) < chance;
    return taken ? 1 / fmin(chance, 1) : 0;
}

/* What the surface sends back of the light on it, and of its own: all layers
 * have one normal, since bumps are left out. The part `sky` of it is open. */
static rgb gathering_shade(const struct gathering *gathering,
                           const struct surface *surface, double sky)
{
    double solid = 1 - fmin(sky, 1);
    rgb light = surface_glow(surface);
    double behind = surface_behind(surface);
    rgb albedo = gather_albedo(surface, sky);
    double matters = rgb_peak(rgb_mul(albedo, gathering->share));
    double count = gathering_chance(gathering, often_lit * matters,
                                    GATHER_MEETING + gathering->met);
    if (count == 0)
        return light;
    struct indirect_share arriving =
        gathering_arriving(gathering, surface, behind, count * matters);
    const struct ambience *ambience = gathering->gather->ambience;
    if (gathering->lamps && gathering->met == 0)
        *gathering->lamps =
            rgb_scale(rgb_mul(*gathering->lamps, albedo), count);
    if (ambience->sky && ambience->everywhere)
        arriving.open = 1;
    rgb ambient = rgb_scale(ambience->light, arriving.open);
    rgb dimmed = rgb_scale(surface_ambient(surface), solid);
    rgb sent =
        rgb_add(rgb_mul(albedo, arriving.light), rgb_mul(dimmed, ambient));
    return rgb_add(light, rgb_scale(sent, count));
}

static rgb gathering_mirrors(const struct gathering *gathering,
                             const struct surface *surface)
{
    rgb light = rgb_grey(0);
    if (gathering->mirrors >= GATHER_MIRRORS)
        return light;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb share = rgb_mul(layer->weight, layer->reflection);
        double matters = rgb_peak(rgb_mul(share, gathering->share));
        if (matters < gather_least)
            continue;
        double count =
            gathering_chance(gathering, often_mirrored * matters,
                             GATHER_MIRROR + (uint32_t)gathering->mirrors);
        if (count == 0)
            continue;
        struct gathering branch = *gathering;
        branch.share = rgb_scale(share, count);
        branch.mirrors++;
        branch.met++;
        branch.ray.origin = surface->point;
        branch.ray.direction = surface_mirrored(
            surface->normal, gathering->ray.direction, layer->normal);
        light = rgb_add(light, gathering_follow(&branch, NULL, NULL));
    }
    return light;
}

/* Whether the ray goes out of a body that it set out in, so flatly that all of
 * it stays there: as light that comes up to the surface of water far from the
 * upright. A ray that came into the body without being bent goes out. */
static bool gathering_stays(struct gathering *gathering,
                            const struct surface *surface)
{
    const struct interior *interior = surface->at->leaf->look->interior;
    const double leaves =
        vec3_dot(gathering->ray.direction, surface->at->normal);
    if (!interior || !(interior->ior > 1) ||
        gathering->mirrors >= GATHER_MIRRORS)
        return false;
    if (leaves < 0 || gathering->inside > 0) {
        gathering->inside += leaves < 0 ? 1 : -1;
        return false;
    }
    return (1 - leaves * leaves) * interior->ior * interior->ior > 1;
}

/* Goes on behind the surface or, as the tracer has it, with no less before it.
 * What it sends is `sent` beside what mirrors there. */
static rgb gathering_pass(struct gathering *gathering,
                          const struct surface *surface, rgb sent)
{
    const rgb share = gathering->share, passed = surface_passed(surface);
    if (rgb_peak(passed) > 0 && gathering_stays(gathering, surface)) {
        gathering->ray.direction =
            surface_mirrored(surface->normal, gathering->ray.direction,
                             surface->layer[0].normal);
        gathering->mirrors++;
    } else {
        sent = rgb_add(sent, gathering_mirrors(gathering, surface));
        gathering->share = rgb_mul(share, passed);
    }
    gathering->ray.origin = surface->point;
    gathering->met++;
    return rgb_mul(share, sent);
}

/* One surface on the way; returns false if it ends here. Its own light into
 * *glow, unless that is NULL. */
static bool gathering_meet(struct gathering *gathering,
                           const struct intersection *at, rgb *light, rgb *glow)
{
    struct surface surface;
    gather_surface(gathering->gather, &gathering->ray, at, &surface);
    if (gathering->gather->wide > 0 && gathering->before == 0 &&
        gathering->met == 0)
        gather_paint(&surface, gathering->gather->wide * at->t);
    if (glow)
        *glow = rgb_mul(gathering->share, surface_glow(&surface));
    double sky = surface_sky(&surface);
    gathering_opens(gathering, sky);
    rgb sent = gathering_shade(gathering, &surface, sky);
    *light = rgb_add(*light, gathering_pass(gathering, &surface, sent));
    return rgb_peak(gathering->share) >= gather_least;
}

/* The ray leaves the scene. */
static rgb gathering_beyond(struct gathering *gathering)
{
    const struct ambience *ambience = gathering->gather->ambience;
    gathering_opens(gathering, 1);
    if (!ambience->sky)
        return rgb_grey(0);
    rgb sky = background_light(ambience->scene, gathering->ray.direction);
    return rgb_mul(gathering->share, sky);
}

/* What it meets next. */
static bool gathering_trace(struct gathering *gathering,
                            struct intersection *at)
{
    bool known = gathering->known;
    const struct glimpse glimpse = { surface_offset(gathering->ray.origin),
                                     (double)INFINITY, gather_spread };
    gathering->known = false;
    if (known)
        return at->leaf;
    gathering->worker->counters.shadow_rays++;
    return world_glimpse(gathering->gather->lamps->world, &gathering->ray,
                         glimpse, RAY_GATHER, at);
}

rgb gathering_follow(struct gathering *gathering, struct intersection *first,
                     rgb *glow)
{
    rgb light = rgb_grey(0);
    struct intersection next, *at = first ? first : &next;
    for (int i = 0; i < GATHER_PANES; i++) {
        bool met = gathering_trace(gathering, at);
        gathering_fog(gathering, met ? at->t : (double)INFINITY, &light);
        if (!met)
            return rgb_add(light, gathering_beyond(gathering));
        if (!gathering_meet(gathering, at, &light, i == 0 ? glow : NULL))
            break;
        at = &next;
    }
    return light;
}

static void gather_along(struct gathering *gathering,
                         struct gathered_ray *gathered)
{
    gathering->share = rgb_grey(1);
    gathering->open = &gathered->open;
    gathering->lamps = &gathered->lamps;
    gathered->lamps = rgb_grey(0);
    gathered->open = 0;
    gathered->glow = rgb_grey(0);
    gathered->light =
        gathering_follow(gathering, &gathered->at, &gathered->glow);
}

void gather_radiance(const struct gather *gather, struct worker *worker,
                     const struct ray *ray, const struct draws *draws,
                     struct gathered_ray *gathered)
{
    struct gathering gathering = {
        .gather = gather, .worker = worker, .draws = draws, .ray = *ray
    };
    gathered->at.leaf = NULL;
    gather_along(&gathering, gathered);
}

void gather_met(const struct gather *gather, struct worker *worker,
                const struct ray *ray, const struct draws *draws,
                const rgb *lamplight, struct gathered_ray *gathered)
{
    struct gathering gathering = { .gather = gather,
                                   .worker = worker,
                                   .draws = draws,
                                   .ray = *ray,
                                   .known = true,
                                   .lamplight = lamplight };
    gather_along(&gathering, gathered);
}
