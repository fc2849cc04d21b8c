/* Places that ask for others: see corner.h. */
#include "lightmesh/corner.h"

#include "lightmesh/near_field.h"
#include "lightmesh/tuning.h"

struct receiver corner_receiver(const struct receiver *like,
                                const struct ray *ray,
                                const struct intersection *at, int coarser)
{
    struct receiver receiver = *like;
    receiver.point = at->point;
    receiver.side = vec3_dot(at->face, ray->direction) > 0
                        ? vec3_negate(at->face)
                        : at->face;
    receiver.normal = receiver.side;
    receiver.from = ray->origin;
    receiver.at = NULL;
    receiver.weight = point_mesh_typical_worth(coarser);
    return receiver;
}

void corner_place(struct corner *corner, const struct indirect_mesh *mesh,
                  const struct receiver *receiver)
{
    const struct lattice *lattice = &mesh->points.lattice;
    double coarse;
    int level =
        lattice_level(lattice, &receiver->view, receiver->point, &coarse);
    corner->met = true;
    corner->point = receiver->point;
    corner->side = receiver->side;
    corner->reach = lattice_spacing(lattice, level);
}

void corner_ask(struct corner *corner, const struct indirect_mesh *mesh,
                struct worker *worker, const struct receiver *receiver,
                int rays)
{
    corner->light = indirect_mesh_blend(mesh, worker, receiver);
    corner->share =
        near_field_share(mesh, worker, receiver, rays, &corner->light);
}

bool corner_serves(const struct corner *corner, const struct receiver *receiver)
{
    if (!corner->met ||
        vec3_dot(corner->side, receiver->side) < indirect_pixels_bend)
        return false;
    vec3 between = vec3_sub(corner->point, receiver->point);
    double apart = vec3_length(between);
    double rise = fmax(fabs(vec3_dot(between, receiver->side)),
                       fabs(vec3_dot(between, corner->side)));
    return apart <= corner->reach && rise <= indirect_pixels_rise * apart;
}

bool receiver_is_bumpy(const struct receiver *receiver)
{
    return vec3_dot(receiver->normal, receiver->side) < indirect_pixels_flat;
}

struct indirect_share corner_share(const struct corner *corner,
                                   const struct receiver *receiver)
{
    return receiver_is_bumpy(receiver)
               ? indirect_light_share(&corner->light, receiver->normal)
               : corner->share;
}
