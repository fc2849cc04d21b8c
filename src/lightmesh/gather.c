/* Gather rays: see gather.h. */
#include "lightmesh/gather.h"

#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/indirect.h"
#include "lightmesh/near_field.h"
#include "lightmesh/onward.h"
#include "lightmesh/tuning.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* A gather ray on its way. */
struct gathering {
    const struct gather *gather;
    struct worker *worker;
    const struct draws *draws;
    struct ray ray;
    rgb share;    /* of what it meets next */
    double *open; /* the sum of what leaves the scene */
    int mirrors;
    uint32_t met;         /* surfaces */
    int before;           /* surfaces that scattered what it brings */
    bool known;           /* what it meets next has been found */
    const rgb *lamplight; /* on the first surface that it meets, on the side
                           * that it comes to; NULL: to be found */
};

static rgb gathering_follow(struct gathering *gathering,
                            struct intersection *first, rgb *glow);

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

/* A ray that goes on from there, as sample *draws; what it brings will be in
 * *found. */
static struct gathering gathering_further(const struct gathering *gathering,
                                          const struct surface *surface,
                                          const struct draws *draws,
                                          struct gathered_ray *found)
{
    vec3 way = onward_way(gathering->gather->onwards, gathering->draws,
                          gathering->met);
    found->at.leaf = NULL;
    found->glow = rgb_grey(0);
    found->open = 0;
    return (struct gathering){
        .gather = gathering->gather,
        .worker = gathering->worker,
        .draws = draws,
        .ray = { surface->point, warp_turned(way, surface->side) },
        .share = rgb_grey(1),
        .open = &found->open,
        .mirrors = gathering->mirrors,
        .before = gathering->before + 1,
    };
}

/* One ray more from there, as often as it matters: by how much it differs from
 * what is usual, which may be less than nothing. */
static struct indirect_share gathering_onward(const struct gathering *gathering,
                                              const struct surface *surface,
                                              double matters)
{
    const struct gather *gather = gathering->gather;
    struct indirect_share share = gather->around;
    bool blind = gather->close && gathering->before == 0;
    double often = blind ? onward_often_blind : onward_often;
    double chance = fmin(often * matters, 1);
    if (gathering->before >= ONWARD_MOST ||
        onward_chance(gather->onwards, gathering->draws, gathering->met) >=
            chance)
        return share;
    const struct draws draws = onward_draws(gathering->draws, gathering->met);
    struct gathered_ray found;
    struct gathering further =
        gathering_further(gathering, surface, &draws, &found);
    const struct ray ray = further.ray;
    double density = vec3_dot(ray.direction, surface->side) / WARP_PI;
    found.light = gathering_follow(&further, &found.at, &found.glow);
    found.light =
        rgb_add(gather_balanced(gather, &ray, density, &found),
                gather_picked(gather, gathering->worker, surface, &draws));
    share.light = rgb_mix(share.light, found.light, 1 / chance);
    share.open += (found.open - share.open) / chance;
    return share;
}

bool gather_closes(const struct gather *gather, struct worker *worker,
                   const struct receiver *receiver,
                   struct indirect_share *share)
{
    rgb light;
    if (!gather->close ||
        !gather->close(gather->close_context, worker, receiver->point,
                       receiver->normal, receiver->from, &light))
        return false;
    *share = (struct indirect_share){ light, 0 };
    return true;
}

/* What the points around say of a surface close to the place that asks. In a
 * crevice, which is dark inside, what hides it from the place hides it from
 * that surface as well: one ray more tells. */
static struct indirect_share gathering_here(const struct gathering *gathering,
                                            const struct surface *surface)
{
    const struct gather *gather = gathering->gather;
    struct indirect_share share =
        indirect_light_share(gather->here, surface->normal);
    if (gathering->before > 0 || gather->crevice == 0)
        return share;
    const struct draws draws = onward_draws(gathering->draws, gathering->met);
    struct gathered_ray found;
    struct gathering further =
        gathering_further(gathering, surface, &draws, &found);
    further.known = true;
    gathering->worker->counters.shadow_rays++;
    const struct glimpse near = { surface_offset(surface->point), gather->reach,
                                  gather_spread };
    if (!world_glimpse(gather->lamps->world, &further.ray, near, RAY_REFLECTION,
                       &found.at))
        return share;
    double close =
        gather->crevice * near_field_closeness(found.at.t, gather->reach);
    found.light = gathering_follow(&further, &found.at, &found.glow);
    if (rgb_peak(found.glow) > 0)
        return share;
    share.light = rgb_mix(share.light, found.light, close);
    share.open += (found.open - share.open) * close;
    return share;
}

/* What surfaces send to the receiver, if mesh points or the skeleton know. */
static bool gathering_known(const struct gathering *gathering,
                            const struct surface *surface,
                            const struct receiver *receiver,
                            struct indirect_share *share)
{
    const struct gather *gather = gathering->gather;
    bool here = gather->here && gathering->met == 0;
    if (here)
        *share = gathering_here(gathering, surface);
    return here ||
           (gather->indirect &&
            indirect_mesh_nearest(gather->indirect, gathering->worker, receiver,
                                  gather_jitter(gathering->draws), share)) ||
           gather_closes(gather, gathering->worker, receiver, share);
}

/* All light on the surface, of which the share `matters` is seen. Where the
 * skeleton ends the row of bounces it has the ambient light as well. */
static struct indirect_share gathering_share(const struct gathering *gathering,
                                             const struct surface *surface,
                                             double matters)
{
    const struct gather *gather = gathering->gather;
    const struct receiver receiver = { .point = surface->point,
                                       .side = surface->side,
                                       .normal = surface->normal,
                                       .from = gathering->ray.origin,
                                       .view = gather->view,
                                       .weight = 1 };
    rgb light = gathering->lamplight && gathering->met == 0
                    ? *gathering->lamplight
                    : gather_lamps(gather, gathering->worker, gathering->draws,
                                   gathering->before > 0, surface, &receiver);
    struct indirect_share more = gather->around;
    bool found = gathering_known(gathering, surface, &receiver, &more);
    if (!found && gather->onward)
        more = gathering_onward(gathering, surface, matters);
    else if (!found && gather->indirect)
        more =
            indirect_mesh_light(gather->indirect, gathering->worker, &receiver);
    more.light = rgb_add(bounce_toned(&gather->tone, more.light), light);
    return more;
}

/* What arrives on its other side, as on a leaf's. */
static rgb gathering_behind(const struct gathering *gathering,
                            const struct surface *surface, double matters)
{
    struct surface other = *surface;
    struct gathering from = *gathering;
    other.side = vec3_negate(surface->side);
    other.normal = vec3_negate(surface->normal);
    from.lamplight = NULL;
    from.ray.origin =
        vec3_sub(vec3_scale(surface->point, 2), gathering->ray.origin);
    return gathering_share(&from, &other, matters).light;
}

/* And the part `behind` of that. */
static struct indirect_share
gathering_through(const struct gathering *gathering,
                  const struct surface *surface, double behind, double matters)
{
    struct indirect_share share = gathering_share(gathering, surface, matters);
    if (behind > 0)
        share.light = rgb_add_scaled(
            share.light, gathering_behind(gathering, surface, behind * matters),
            behind);
    return share;
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
    rgb albedo = rgb_scale(
        albedo_bounded(surface_returned(surface), RETURNED_MOST / (1 + behind)),
        solid);
    double matters = rgb_peak(rgb_mul(albedo, gathering->share));
    double count = gathering_chance(gathering, often_lit * matters,
                                    GATHER_MEETING + gathering->met);
    if (count == 0)
        return light;
    struct indirect_share arriving =
        gathering_through(gathering, surface, behind, count * matters);
    const struct ambience *ambience = gathering->gather->ambience;
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
        vec3 in = gathering->ray.direction;
        double matters = rgb_peak(rgb_mul(share, gathering->share));
        if (matters < gather_least)
            continue;
        double count =
            gathering_chance(gathering, often_mirrored * matters,
                             GATHER_MIRROR + (uint32_t)gathering->mirrors);
        if (count == 0)
            continue;
        double along = vec3_dot(in, layer->normal);
        struct gathering branch = *gathering;
        branch.share = rgb_scale(share, count);
        branch.mirrors++;
        branch.met++;
        branch.ray.origin = surface->point;
        branch.ray.direction =
            vec3_normalise(vec3_along(in, layer->normal, -2 * along));
        light = rgb_add(light, gathering_follow(&branch, NULL, NULL));
    }
    return light;
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
    sent = rgb_add(sent, gathering_mirrors(gathering, &surface));
    *light = rgb_add(*light, rgb_mul(gathering->share, sent));
    gathering->share = rgb_mul(gathering->share, surface_passed(&surface));
    gathering->ray.origin = surface.point;
    gathering->met++;
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
                         glimpse, RAY_REFLECTION, at);
}

/* All light. What is met first into *first, and that one's own light into
 * *glow, where these are wanted. */
static rgb gathering_follow(struct gathering *gathering,
                            struct intersection *first, rgb *glow)
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
