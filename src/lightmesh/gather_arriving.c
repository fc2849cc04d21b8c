/* What arrives at surfaces that gather rays meet: see gathering.h. */
#include "lightmesh/gathering.h"

#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_virtual.h"
#include "lightmesh/indirect.h"
#include "lightmesh/near_field.h"
#include "lightmesh/onward.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

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
    found->lamps = rgb_grey(0);
    return (struct gathering){
        .gather = gathering->gather,
        .worker = gathering->worker,
        .draws = draws,
        .ray = { surface->point, warp_turned(way, surface->side) },
        .share = rgb_grey(1),
        .open = &found->open,
        .lamps = &found->lamps,
        .mirrors = gathering->mirrors,
        .before = gathering->before + 1,
    };
}

/* Nearly all rays come from no crevice. */
static bool gather_is_near(const struct gather *gather,
                           const struct receiver *receiver)
{
    return gather->crevice.known &&
           vec3_length(vec3_sub(receiver->point, receiver->from)) <
               gather->crevice.near;
}

/* How many rays more go on from there, for as much as it matters. */
static double gathering_often(const struct gathering *gathering,
                              const struct receiver *receiver, double matters)
{
    const struct gather *gather = gathering->gather;
    const bool first = gathering->before == 0;
    double often =
        (first && gather->close ? onward_often_blind : onward_often) * matters;
    return first && gather_is_near(gather, receiver)
               ? fmax(often, gather->crevice.least)
               : often;
}

/* What is usual there. */
static struct indirect_share gathering_usual(const struct gather *gather,
                                             const struct receiver *receiver)
{
    struct indirect_share usual = gather->around;
    if (gather_is_near(gather, receiver))
        usual = indirect_light_share(gather->crevice.known, receiver->side);
    return usual;
}

/* One ray more from there, as often as it matters: by how much it differs from
 * what is usual, which may be less than nothing. */
static struct indirect_share gathering_onward(const struct gathering *gathering,
                                              const struct surface *surface,
                                              const struct receiver *receiver,
                                              double matters)
{
    const struct gather *gather = gathering->gather;
    struct indirect_share share = gathering_usual(gather, receiver);
    double chance = fmin(gathering_often(gathering, receiver, matters), 1);
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
        rgb_add(gather_balanced(gather, &ray, density, 1, &found),
                gather_picked(gather, gathering->worker, surface, &draws));
    const struct indirect_share met = { found.light, found.open };
    indirect_share_mix(&share, &met, 1 / chance);
    return share;
}

bool gather_closes(const struct gather *gather, struct worker *worker,
                   const struct receiver *receiver,
                   struct indirect_share *share)
{
    rgb light;
    if (!gather->close || gather_is_near(gather, receiver) ||
        !gather->close(gather->close_context, worker, receiver->point,
                       receiver->normal, receiver->from, &light))
        return false;
    *share = (struct indirect_share){ light, 0 };
    return true;
}

/* What surfaces send to the receiver, if mesh points or the skeleton know. */
static bool gathering_known(const struct gathering *gathering,
                            const struct receiver *receiver,
                            struct indirect_share *share)
{
    const struct gather *gather = gathering->gather;
    bool here = gather->here && gathering->met == 0;
    if (here)
        *share = indirect_light_share(gather->here, receiver->normal);
    return here ||
           (gather->indirect &&
            indirect_mesh_nearest(gather->indirect, gathering->worker, receiver,
                                  gather_jitter(gathering->draws), share)) ||
           gather_closes(gather, gathering->worker, receiver, share);
}

/* How much of lamps' light on the surface virtual lights bring: none of what is
 * on its far side. */
static double gathering_virtual(const struct gathering *gathering,
                                const struct surface *surface)
{
    const vec3 way = gathering->ray.direction;
    if (gathering->met > 0 || gathering->before > 0 ||
        vec3_dot(surface->side, vec3_against(surface->at->face, way)) < 0)
        return 0;
    return gather_virtual_share(gathering->gather, surface->at, way);
}

/* What is left of it. */
static rgb gathering_lamps(const struct gathering *gathering,
                           const struct surface *surface,
                           const struct receiver *receiver)
{
    const struct gather *gather = gathering->gather;
    if (gathering->lamplight && gathering->met == 0)
        return *gathering->lamplight;
    double left = 1 - gathering_virtual(gathering, surface);
    if (!(left > 0))
        return rgb_grey(0);
    return rgb_scale(gather_lamps(gather, gathering->worker, gathering->draws,
                                  gathering->before > 0, surface, receiver),
                     left);
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
                                       .smooth = surface->normal,
                                       .normal = surface->normal,
                                       .from = gathering->ray.origin,
                                       .view = gather->view,
                                       .weight = 1 };
    rgb light = gathering_lamps(gathering, surface, &receiver);
    struct indirect_share more = gather->around;
    bool found = gathering_known(gathering, &receiver, &more);
    if (!found && gather->onward)
        more = gathering_onward(gathering, surface, &receiver, matters);
    else if (!found && gather->indirect)
        more = indirect_mesh_beyond(gather->indirect, gathering->worker,
                                    &receiver);
    const struct finish *finish = texture_finish(surface->at->texture);
    if (finish)
        more.light = rgb_scale(more.light, finish_around(finish));
    more.light = rgb_add(bounce_toned(&gather->tone, more.light), light);
    if (gathering->lamps && gathering->met == 0)
        *gathering->lamps = light;
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
    from.lamps = NULL;
    from.ray.origin = vec3_opposite(gathering->ray.origin, surface->point);
    return gathering_share(&from, &other, matters).light;
}

struct indirect_share gathering_arriving(const struct gathering *gathering,
                                         const struct surface *surface,
                                         double behind, double matters)
{
    struct indirect_share share = gathering_share(gathering, surface, matters);
    if (behind > 0)
        share.light = rgb_add_scaled(
            share.light, gathering_behind(gathering, surface, behind * matters),
            behind);
    return share;
}
