/* The indirect mesh asked for one surface: see mesh_diffuse.h. */
#include "lighting/mesh_diffuse.h"

#include "base/telling.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"

struct diffuse_light mesh_diffuse(const struct mesh_indirect *known,
                                  struct worker *worker,
                                  const struct surface *surface)
{
    const struct indirect_mesh *mesh = known->mesh;
    const struct ambience *ambience = known->ambience;
    const struct surface_layer *layer = &surface->layer[0];
    rgb albedo = surface_albedo(surface);
    rgb ambient = rgb_mul(surface_ambient(surface), ambience->light);
    double most = fmax(rgb_peak(albedo), rgb_peak(ambient));
    struct indirect_share share = { rgb_grey(0), 0 };
    struct receiver receiver = {
        .point = surface->point,
        .side = surface->side,
        .normal = known->smooth ? surface->normal : layer->normal,
        .from = vec3_along(surface->point, surface->view, surface->at->t),
        .pixel = surface->place,
        .view = known->view,
        .weight = surface->weight * most,
    };
    bool beyond = known->pixels && !surface->place;
    if (beyond)
        receiver.view.coarser++;
    unsigned long long rays = worker->counters.shadow_rays;
    if ((layer->finish->diffuse != 0 || rgb_peak(ambient) > 0) &&
        !(known->pixels &&
          indirect_pixels_light(known->pixels, worker, &receiver, &share)) &&
        !(beyond && !indirect_mesh_leaves(mesh, &receiver) &&
          known->worth * receiver.weight < one_point_worth &&
          indirect_mesh_nearest(mesh, worker, &receiver, vec3_make(0, 0, 0),
                                &share)))
        share = indirect_mesh_light(mesh, worker, &receiver);
    if (worker->telling)
        telling_say(worker->telling,
                    "indirect: %.4g %.4g %.4g, %.3g of the ambient light, by "
                    "%s, %llu rays",
                    share.light.r, share.light.g, share.light.b, share.open,
                    indirect_mesh_source(mesh, &receiver),
                    worker->counters.shadow_rays - rays);
    if (ambience->everywhere)
        share.open = 1;
    return (struct diffuse_light){ rgb_scale(ambience->light, share.open),
                                   share.light };
}
