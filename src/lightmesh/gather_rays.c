/* Gather rays together: see gather_rays.h. */
#include "lightmesh/gather_rays.h"

#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_virtual.h"
#include "scene/material.h"
#include "shade/shadow.h"

void gather_rays_add(struct gather_rays *sent, const struct draws *draws,
                     vec3 place, vec3 way)
{
    rays_set(&sent->rays, (int)sent->count, place, way);
    sent->draws[sent->count++] = *draws;
}

bool gather_rays_may_light(const struct gather_rays *sent, unsigned i)
{
    const struct intersection *at = &sent->found[i].at;
    return at->leaf && texture_takes_light(at->texture);
}

void gather_rays_want_light(struct gather_rays *sent, unsigned i)
{
    const struct intersection *at = &sent->found[i].at;
    vec3 normal = vec3_against(at->normal, rays_direction(&sent->rays, (int)i));
    sent->lit.at[i] = (struct lit_place){ at->point, normal, at->leaf,
                                          texture_finish(at->texture) };
    sent->lit.draws[i] = sent->draws[i];
    sent->lit.lanes |= 1u << i;
}

/* What lamps give them, if it is more than one that they light, but for what
 * virtual lights bring. */
static void gather_rays_light(const struct gather *gather,
                              struct worker *worker, struct gather_rays *sent)
{
    struct lit_places *lit = &sent->lit;
    double left[RAY_LANES];
    unsigned brought = 0;
    for (unsigned i = 0; i < sent->count; i++) {
        const struct intersection *at = &sent->found[i].at;
        if (!gather_rays_may_light(sent, i))
            continue;
        vec3 way = rays_direction(&sent->rays, (int)i);
        left[i] = 1 - gather_virtual_share(gather, at, way);
        if (!(left[i] > 0)) {
            lit->light[i] = rgb_grey(0);
            brought |= 1u << i;
            continue;
        }
        gather_rays_want_light(sent, i);
    }
    if (lit->lanes & (lit->lanes - 1)) {
        gather_lamps_many(gather, worker, lit);
        for (unsigned each = lit->lanes; each; each &= each - 1) {
            unsigned i = (unsigned)__builtin_ctz(each);
            lit->light[i] = rgb_scale(lit->light[i], left[i]);
        }
    } else {
        lit->lanes = 0;
    }
    lit->lanes |= brought;
}

void gather_rays_meet(const struct gather *gather, struct worker *worker,
                      double reach, struct gather_rays *sent)
{
    struct rays_span span;
    struct world_hit hits[RAY_LANES];
    for (unsigned i = 0; i < sent->count; i++) {
        const struct ray ray = rays_at(&sent->rays, (int)i);
        span.near[i] = surface_offset(ray.origin);
        span.far[i] = reach;
    }
    rays_fill(&sent->rays, &span, sent->count);
    sent->lit.lanes = 0;
    worker->counters.shadow_rays += sent->count;
    world_closest_many(gather->lamps->world, &sent->rays, &span, sent->count,
                       RAY_GATHER, hits);
    for (unsigned i = 0; i < sent->count; i++) {
        const struct ray ray = rays_at(&sent->rays, (int)i);
        sent->found[i].at.leaf = NULL;
        if (hits[i].leaf)
            world_describe(&ray, &hits[i], &sent->found[i].at);
    }
}

void gather_rays_trace(const struct gather *gather, struct worker *worker,
                       struct gather_rays *sent)
{
    gather_rays_meet(gather, worker, (double)INFINITY, sent);
    if (gather->together)
        gather_rays_light(gather, worker, sent);
}

const struct gathered_ray *gather_rays_follow(const struct gather *gather,
                                              struct worker *worker,
                                              struct gather_rays *sent,
                                              unsigned i)
{
    const struct ray ray = rays_at(&sent->rays, (int)i);
    bool lit = sent->lit.lanes >> i & 1;
    gather_met(gather, worker, &ray, &sent->draws[i],
               lit ? &sent->lit.light[i] : NULL, &sent->found[i]);
    return &sent->found[i];
}
