/* Short rays: see near_field.h. */
#include "lightmesh/near_field.h"

#include "base/warp.h"
#include "lightmesh/indirect.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"

/* Numbers of its own, apart from those of mesh points. */
static const uint64_t near_key = 0x6e656172;

/* What the points around say of a way: radiance in the units of
 * gather_radiance, which are those of irradiance from all sides. */
static struct indirect_share light_along(const struct indirect_light *light,
                                         vec3 way)
{
    double basis[HARMONICS];
    struct indirect_share along = { rgb_grey(0), 0 };
    harmonics_basis(way, basis);
    for (int i = 0; i < HARMONICS; i++) {
        const struct harmonics *h = &light->light;
        rgb part = { (double)h->r[i], (double)h->g[i], (double)h->b[i] };
        along.light = rgb_add_scaled(along.light, part, WARP_PI * basis[i]);
        along.open += WARP_PI * basis[i] * (double)light->open[i];
    }
    return along;
}

/* One ray. Returns whether something is near; into *more, by how much light
 * differs then. */
static bool near_look(const struct indirect_mesh *mesh, struct worker *worker,
                      const struct ray *ray, double reach,
                      const struct draws *draws,
                      const struct indirect_light *known,
                      struct indirect_share *more)
{
    struct intersection at;
    struct gathered_ray found;
    *more = (struct indirect_share){ rgb_grey(0), 0 };
    worker->counters.shadow_rays++;
    if (!world_within(mesh->points.world, ray, surface_offset(ray->origin),
                      reach, RAY_REFLECTION, &at))
        return false;
    gather_radiance(&mesh->gather, worker, ray, draws, &found);
    if (rgb_peak(found.glow) > 0)
        return true;
    struct indirect_share along = light_along(known, ray->direction);
    more->light = rgb_sub(found.light, along.light);
    more->open = found.open - along.open;
    return true;
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

struct indirect_share near_field_share(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       struct near_rays rays,
                                       struct indirect_light *light)
{
    const struct indirect_light known = *light;
    struct indirect_share share = indirect_light_share(light, receiver->side);
    uint64_t key = mesh->gather.lamps->seed ^ near_key;
    double reach = near_reach(mesh, receiver), count = rays.count;
    bool any = false;
    for (int i = 0; i < rays.count && (any || 2 * i < rays.count); i++) {
        uint32_t index = rays.set * (uint32_t)rays.count + (uint32_t)i;
        struct draws draws = { key, index };
        struct indirect_share more;
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
        struct ray ray = { receiver->point, warp_lobe(u, receiver->side, 1) };
        double density = vec3_dot(ray.direction, receiver->side) / WARP_PI;
        if (!(density > 0) ||
            !near_look(mesh, worker, &ray, reach, &draws, &known, &more))
            continue;
        any = true;
        indirect_light_add(light, ray.direction, more.light, more.open,
                           density * count);
        share.light = rgb_add_scaled(share.light, more.light, 1 / count);
        share.open += more.open / count;
    }
    rgb sum = share.light;
    share.light = rgb_make(fmax(sum.r, 0), fmax(sum.g, 0), fmax(sum.b, 0));
    share.open = fmin(fmax(share.open, 0), 1);
    return share;
}
