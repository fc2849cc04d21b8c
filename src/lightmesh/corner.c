/* Places that ask for others: see corner.h. */
#include "lightmesh/corner.h"

#include "lightmesh/near_field.h"
#include "lightmesh/tuning.h"

void corner_here(struct corner *corner, const struct indirect_mesh *mesh,
                 const struct receiver *receiver)
{
    const struct lattice *lattice = &mesh->points.lattice;
    double coarse;
    int level =
        lattice_level(lattice, &receiver->view, receiver->point, &coarse);
    *corner = (struct corner){
        .met = true,
        .point = receiver->point,
        .side = receiver->side,
        .from = receiver->from,
        .reach = lattice_spacing(lattice, level),
    };
}

void corner_meet(struct corner *corner, const struct indirect_mesh *mesh,
                 const struct receiver *like, const struct ray *ray,
                 const struct intersection *at)
{
    struct receiver receiver = *like;
    receiver.point = at->point;
    receiver.side = vec3_dot(at->face, ray->direction) > 0
                        ? vec3_negate(at->face)
                        : at->face;
    receiver.from = ray->origin;
    corner_here(corner, mesh, &receiver);
}

struct receiver corner_receiver(const struct corner *corner,
                                const struct receiver *like, int coarser)
{
    struct receiver receiver = *like;
    receiver.point = corner->point;
    receiver.side = corner->side;
    receiver.normal = corner->side;
    receiver.from = corner->from;
    receiver.at = NULL;
    receiver.weight = point_mesh_typical_worth(coarser);
    return receiver;
}

void corner_ask(struct corner_light *light, const struct indirect_mesh *mesh,
                struct worker *worker, const struct receiver *receiver,
                int rays)
{
    light->light = indirect_mesh_blend(mesh, worker, receiver);
    light->share =
        near_field_share(mesh, worker, receiver, rays, &light->light);
}

bool corner_faces(const struct corner *corner, const struct receiver *receiver)
{
    return vec3_dot(corner->side, receiver->side) >= indirect_pixels_bend;
}

bool corner_serves(const struct corner *corner, const struct receiver *receiver)
{
    if (!corner->met || !corner_faces(corner, receiver))
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

struct indirect_share corner_share(const struct corner_light *light,
                                   const struct receiver *receiver)
{
    return receiver_is_bumpy(receiver)
               ? indirect_light_share(&light->light, receiver->normal)
               : light->share;
}
