/* Crevices: see near_own.h. */
#include "lightmesh/near_own.h"

#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/indirect.h"
#include "lightmesh/near_glow.h"
#include "lightmesh/tuning.h"

/* A place that gathers. */
struct owning {
    const struct indirect_mesh *mesh;
    struct gather gather; /* of its rays: these bring all that lamps light,
                           * without virtual lights */
    struct worker *worker;
    const struct receiver *receiver;
    int rays; /* the first ones of the mesh's */
    struct indirect_share share;
    struct indirect_light *light;
};

/* How much of that glow isn't found by those who look for it near by. */
static double owning_glow(const struct owning *own, const struct leaf *leaf,
                          double distance)
{
    return 1 - near_glow_share(own->mesh->near_glow, leaf, distance);
}

/* What comes that way, of which so many are drawn per solid angle. */
static void owning_add(struct owning *own, vec3 way, rgb light, double open,
                       double density)
{
    const double cosine = vec3_dot(way, own->receiver->side),
                 part = fmax(cosine, 0) / (WARP_PI * density);
    if (!(part > 0))
        return;
    own->share.light = rgb_add_scaled(own->share.light, light, part);
    own->share.open += part * open;
    indirect_light_add(own->light, way, light, open, density);
}

/* Rays from number `first` on, as many as go together. */
static void owning_look(struct owning *own, int first)
{
    const struct near_ways *ways = &own->mesh->near_own;
    struct gather_rays sent;
    sent.count = 0;
    for (int i = first; i < own->rays && sent.count < RAY_LANES; i++) {
        const struct draws draws = near_draws(&own->gather, (unsigned)i);
        gather_rays_add(&sent, &draws, own->receiver->point,
                        warp_turned(ways->ways[i], own->receiver->side));
    }
    gather_rays_trace(&own->gather, own->worker, &sent);
    for (unsigned i = 0; i < sent.count; i++) {
        const struct ray ray = rays_at(&sent.rays, (int)i);
        const double density =
            vec3_dot(ray.direction, own->receiver->side) / WARP_PI;
        if (!(density > 0))
            continue;
        const struct gathered_ray *found =
            gather_rays_follow(&own->gather, own->worker, &sent, i);
        const double left = rgb_peak(found->glow) > 0
                                ? owning_glow(own, found->at.leaf, found->at.t)
                                : 1;
        owning_add(own, ray.direction,
                   gather_balanced(&own->gather, &ray, density, left, found),
                   found->open, density * own->rays);
    }
}

/* Picks, likewise. */
static void owning_pick(struct owning *own, int first)
{
    struct gathered_glow found[RAY_LANES];
    struct draws draws[RAY_LANES];
    unsigned picks = 0;
    for (int i = first; i < own->rays && picks < RAY_LANES; i++)
        draws[picks++] = near_draws(&own->gather, (unsigned)i);
    picks = gather_pick(&own->gather, own->worker, own->receiver->point, draws,
                        picks, found);
    for (unsigned i = 0; i < picks; i++) {
        const double cosine = vec3_dot(found[i].direction, own->receiver->side),
                     density = found[i].density + fmax(cosine, 0) / WARP_PI,
                     left = owning_glow(own, found[i].leaf, found[i].distance);
        owning_add(own, found[i].direction, rgb_scale(found[i].light, left), 0,
                   density * own->rays);
    }
}

struct indirect_share near_own_gather(const struct indirect_mesh *mesh,
                                      struct worker *worker,
                                      const struct receiver *receiver,
                                      const struct indirect_light *known,
                                      double counts,
                                      struct indirect_light *light)
{
    struct owning own = { .mesh = mesh,
                          .gather = mesh->gather,
                          .worker = worker,
                          .receiver = receiver,
                          .rays = mesh->near_own.count,
                          .light = light };
    *light = indirect_light_none;
    own.gather.virtual_lights = NULL;
    own.gather.crevice = (struct gather_crevice){
        .known = known,
        .near = near_field_reach_at(mesh, receiver),
        .least = own.rays < RAY_LANES ? 0 : 1,
    };
    own.gather.onwards = &mesh->near_onwards;
    if (counts < own_little && own.rays > RAY_LANES)
        own.rays = RAY_LANES;
    for (int first = 0; first < own.rays; first += RAY_LANES) {
        owning_look(&own, first);
        if (emitters_any(mesh->gather.emitters))
            owning_pick(&own, first);
    }
    return own.share;
}
