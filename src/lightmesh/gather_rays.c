/* Gather rays together: see gather_rays.h. */
#include "lightmesh/gather_rays.h"

#include "shade/shadow.h"

void gather_rays_add(struct gather_rays *sent, const struct draws *draws,
                     vec3 place, vec3 way)
{
    rays_set(&sent->rays, (int)sent->count, place, way);
    sent->draws[sent->count++] = *draws;
}

void gather_rays_trace(const struct gather *gather, struct worker *worker,
                       double reach, struct gather_rays *sent)
{
    struct rays_span span = { { 0 }, { 0 } };
    for (unsigned i = 0; i < sent->count; i++) {
        const struct ray ray = rays_at(&sent->rays, (int)i);
        span.near[i] = surface_offset(ray.origin);
        span.far[i] = reach;
    }
    worker->counters.shadow_rays += sent->count;
    world_closest_many(gather->lamps->world, &sent->rays, &span, sent->count,
                       RAY_REFLECTION, sent->hits);
}

void gather_rays_follow(const struct gather *gather, struct worker *worker,
                        const struct gather_rays *sent, unsigned i,
                        struct gathered_ray *found)
{
    const struct ray ray = rays_at(&sent->rays, (int)i);
    found->at.leaf = NULL;
    if (sent->hits[i].leaf)
        world_describe(&ray, &sent->hits[i], &found->at);
    gather_met(gather, worker, &ray, &sent->draws[i], found);
}
