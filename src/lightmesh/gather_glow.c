/* Glowing things, picked: see gather_glow.h. */
#include "lightmesh/gather_glow.h"

#include "base/warp.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/gather_rays.h"
#include "shade/finish.h"

/* How likely what the ray met is picked there, per solid angle; 0 unless it
 * glows. */
static double glow_density(const struct gather *gather, const struct ray *ray,
                           const struct gathered_ray *found)
{
    return emitters_any(gather->emitters) && rgb_peak(found->glow) > 0
               ? emitters_density(gather->emitters, ray->origin, ray->direction,
                                  &found->at)
               : 0;
}

rgb gather_balanced(const struct gather *gather, const struct ray *ray,
                    double density, double left,
                    const struct gathered_ray *found)
{
    double other = glow_density(gather, ray, found);
    return rgb_add_scaled(found->light, found->glow,
                          left * emitters_balance(density, other) - 1);
}

rgb gather_glow_at(const struct gather *gather, const struct ray *ray,
                   const struct intersection *at)
{
    struct surface surface;
    gather_surface(gather, ray, at, &surface);
    return surface_glow(&surface);
}

/* Whether it is met, and glows there. */
static bool pick_glows(const struct gather *gather, const struct ray *ray,
                       const struct emitter_pick *pick,
                       const struct intersection *at,
                       struct gathered_glow *found)
{
    if (!emitter_is_met(pick, at))
        return false;
    *found = (struct gathered_glow){ pick->direction,
                                     gather_glow_at(gather, ray, at),
                                     pick->density, pick->leaf, at->t };
    return rgb_peak(found->light) != 0;
}

unsigned gather_pick(const struct gather *gather, struct worker *worker,
                     vec3 place, const struct draws *draws, unsigned count,
                     struct gathered_glow *found)
{
    struct emitter_pick picks[RAY_LANES];
    struct gather_rays sent;
    unsigned met = 0;
    sent.count = 0;
    for (unsigned i = 0; i < count; i++) {
        double which = draw_unit(&draws[i], GATHER_WHICH), u[2];
        struct emitter_pick *pick = &picks[sent.count];
        draw_pair(&draws[i], GATHER_WHERE, u);
        if (emitters_pick(gather->emitters, place, which, u, pick))
            gather_rays_add(&sent, &draws[i], place, pick->direction);
    }
    gather_rays_meet(gather, worker, (double)INFINITY, &sent);
    for (unsigned i = 0; i < sent.count; i++) {
        const struct ray ray = rays_at(&sent.rays, (int)i);
        met +=
            pick_glows(gather, &ray, &picks[i], &sent.found[i].at, &found[met]);
    }
    return met;
}

rgb gather_picked(const struct gather *gather, struct worker *worker,
                  const struct surface *surface, const struct draws *draws)
{
    struct gathered_glow found;
    if (!emitters_any(gather->emitters) ||
        !gather_pick(gather, worker, surface->point, draws, 1, &found))
        return rgb_grey(0);
    double density = vec3_dot(found.direction, surface->side) / WARP_PI;
    return rgb_scale(found.light, emitters_balance(density, found.density));
}
