/* Glowing things, picked: see gather_glow.h. */
#include "lightmesh/gather_glow.h"

#include "base/warp.h"
#include "lightmesh/gather_paint.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* What glows of itself at the first surface along the ray, if that is the
 * leaf's. */
static rgb glow_met(const struct gather *gather, struct worker *worker,
                    const struct ray *ray, const struct leaf *leaf,
                    struct intersection *at)
{
    struct surface surface;
    worker->counters.shadow_rays++;
    if (!world_closest(gather->lamps->world, ray, surface_offset(ray->origin),
                       RAY_REFLECTION, at) ||
        at->leaf != leaf)
        return rgb_grey(0);
    gather_surface(gather, ray, at, &surface);
    return surface_glow(&surface);
}

rgb gather_balanced(const struct gather *gather, const struct ray *ray,
                    double density, const struct gathered_ray *found)
{
    if (!emitters_any(gather->emitters) || !(rgb_peak(found->glow) > 0))
        return found->light;
    double other = emitters_density(gather->emitters, ray->origin,
                                    ray->direction, &found->at);
    double twice = isfinite(other) ? other / (density + other) : 1;
    return rgb_add_scaled(found->light, found->glow, -twice);
}

bool gather_pick(const struct gather *gather, struct worker *worker, vec3 place,
                 const struct draws *draws, struct gathered_glow *found)
{
    double which = draw_unit(draws, GATHER_WHICH), u[2];
    struct emitter_pick pick;
    struct intersection at;
    draw_pair(draws, GATHER_WHERE, u);
    if (!emitters_pick(gather->emitters, place, which, u, &pick))
        return false;
    struct ray ray = { place, pick.direction };
    found->light = glow_met(gather, worker, &ray, pick.leaf, &at);
    found->direction = pick.direction;
    found->density = pick.density;
    if (rgb_peak(found->light) == 0)
        return false;
    return isinf(pick.distance) ||
           fabs(at.t - pick.distance) <= 1e-5 * (1 + at.t);
}

rgb gather_picked(const struct gather *gather, struct worker *worker,
                  const struct surface *surface, const struct draws *draws)
{
    struct gathered_glow found;
    if (!emitters_any(gather->emitters) ||
        !gather_pick(gather, worker, surface->point, draws, &found))
        return rgb_grey(0);
    double density = vec3_dot(found.direction, surface->side) / WARP_PI;
    if (!(density > 0))
        return rgb_grey(0);
    return rgb_scale(found.light, density / (density + found.density));
}
