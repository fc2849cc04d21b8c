/* Short rays: see near_field.h. */
#include "lightmesh/near_field.h"

#include "base/warp.h"
#include "lightmesh/indirect.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"

/* Numbers of its own, apart from those of mesh points. */
static const uint64_t near_key = 0x6e656172;

/* What the points around say of a way, as brightness: no less than nothing. */
struct along {
    double light, open;
};

/* A place that looks around. */
struct nearby {
    const struct indirect_mesh *mesh;
    struct gather gather; /* what is met is lit by the same points */
    struct worker *worker;
    const struct receiver *receiver;
    double reach; /* of its rays, units */
    int rays;
    struct along all, hidden;     /* sums of what the points say */
    struct indirect_light met;    /* what comes from what was met, */
    struct indirect_share shares; /* and what the side gets of it */
};

static struct along light_along(const struct indirect_light *light, vec3 way)
{
    double basis[HARMONICS];
    struct along along = { 0, 0 };
    harmonics_basis(way, basis);
    for (int i = 0; i < HARMONICS; i++) {
        const struct harmonics *h = &light->light;
        rgb part = { (double)h->r[i], (double)h->g[i], (double)h->b[i] };
        along.light += rgb_brightness(part) * basis[i];
        along.open += (double)light->open[i] * basis[i];
    }
    return (struct along){ fmax(along.light, 0), fmax(along.open, 0) };
}

/* One ray, which is drawn by the cosine. Returns whether it met something that
 * doesn't glow. */
static bool nearby_look(struct nearby *nearby, const struct ray *ray,
                        const struct draws *draws)
{
    const struct world *world = nearby->mesh->points.world;
    struct gathered_ray found;
    double density = vec3_dot(ray->direction, nearby->receiver->side) / WARP_PI;
    double count = nearby->rays;
    nearby->worker->counters.shadow_rays++;
    if (!(density > 0) ||
        !world_within(world, ray, surface_offset(ray->origin), nearby->reach,
                      RAY_REFLECTION, &found.at))
        return false;
    gather_met(&nearby->gather, nearby->worker, ray, draws, &found);
    if (rgb_peak(found.glow) > 0)
        return false;
    indirect_light_add(&nearby->met, ray->direction, found.light, found.open,
                       density * count);
    nearby->shares.light =
        rgb_add_scaled(nearby->shares.light, found.light, 1 / count);
    nearby->shares.open += found.open / count;
    return true;
}

/* All rays, or half of them. Returns whether anything is near. */
static bool nearby_look_around(struct nearby *nearby,
                               const struct indirect_light *light)
{
    const struct receiver *receiver = nearby->receiver;
    uint64_t key = nearby->mesh->gather.lamps->seed ^ near_key;
    bool any = false;
    for (int i = 0; i < nearby->rays && (any || 2 * i < nearby->rays); i++) {
        struct draws draws = { key, (uint32_t)i };
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
        struct ray ray = { receiver->point, warp_lobe(u, receiver->side, 1) };
        struct along along = light_along(light, ray.direction);
        bool hidden = nearby_look(nearby, &ray, &draws);
        nearby->all.light += along.light;
        nearby->all.open += along.open;
        nearby->hidden.light += hidden ? along.light : 0;
        nearby->hidden.open += hidden ? along.open : 0;
        any = any || hidden;
    }
    return any;
}

/* How far from here mesh points may be that light it. */
static double near_reach(const struct indirect_mesh *mesh,
                         const struct receiver *receiver)
{
    const struct lattice *lattice = &mesh->points.lattice;
    double coarse;
    int level =
        lattice_level(lattice, &receiver->view, receiver->point, &coarse);
    return near_field_reach * lattice_spacing(lattice, level);
}

static double share_left(double hidden, double all)
{
    return all > 0 ? 1 - hidden / all : 1;
}

struct indirect_share near_field_share(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       int rays, struct indirect_light *light)
{
    struct nearby nearby = {
        .mesh = mesh,
        .gather = mesh->gather,
        .worker = worker,
        .receiver = receiver,
        .reach = near_reach(mesh, receiver),
        .rays = rays,
    };
    nearby.gather.indirect = mesh;
    bool any = nearby_look_around(&nearby, light);
    if (any)
        indirect_light_dim(light,
                           share_left(nearby.hidden.light, nearby.all.light),
                           share_left(nearby.hidden.open, nearby.all.open));
    struct indirect_share share = indirect_light_share(light, receiver->side);
    share.light = rgb_add(share.light, nearby.shares.light);
    share.open = fmin(share.open + nearby.shares.open, 1);
    if (any)
        indirect_light_mix(light, &nearby.met, 1);
    return share;
}
