/* Places that ask for others: see corner.h. */
#include "lightmesh/corner.h"

#include "lightmesh/indirect.h"
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
    receiver.side = vec3_against(at->face, ray->direction);
    receiver.from = ray->origin;
    corner_here(corner, mesh, &receiver);
}

void corner_turn(struct corner *corner)
{
    corner->side = vec3_negate(corner->side);
    corner->from = vec3_opposite(corner->from, corner->point);
}

struct receiver corner_receiver(const struct corner *corner,
                                const struct receiver *like, int coarser)
{
    struct receiver receiver = *like;
    receiver.point = corner->point;
    receiver.side = corner->side;
    receiver.smooth = receiver.normal = corner->side;
    receiver.from = corner->from;
    receiver.at = NULL;
    receiver.at_first = true;
    receiver.weight = point_mesh_typical_worth(coarser);
    return receiver;
}

void corner_ask(struct corner_light *light, const struct indirect_mesh *mesh,
                struct worker *worker, const struct receiver *receiver,
                const struct near_ways *ways)
{
    light->share =
        indirect_mesh_around(mesh, worker, receiver, ways, &light->light).share;
}

bool corner_serves(const struct corner *corner, const struct receiver *receiver)
{
    if (!corner->met ||
        vec3_dot(corner->side, receiver->side) < indirect_pixels_bend)
        return false;
    vec3 between = vec3_sub(corner->point, receiver->point);
    double apart = vec3_dot(between, between);
    double here = vec3_dot(between, receiver->side),
           there = vec3_dot(between, corner->side);
    double rise = indirect_pixels_rise * indirect_pixels_rise * apart;
    return apart <= corner->reach * corner->reach && here * here <= rise &&
           there * there <= rise;
}

bool corner_sees(const struct corner *corner, const struct indirect_mesh *mesh,
                 struct worker *worker, const struct receiver *receiver)
{
    double apart = vec3_length(vec3_sub(corner->point, receiver->point));
    double lift = indirect_pixels_lift * apart;
    vec3 from = vec3_along(receiver->point, receiver->side, lift);
    vec3 to = vec3_along(corner->point, corner->side, lift);
    vec3 between = vec3_sub(to, from);
    double length = vec3_length(between);
    if (!(length > 0))
        return true;
    struct ray ray = { from, vec3_scale(between, 1 / length) };
    worker->counters.shadow_rays++;
    return !world_occluded(mesh->points.world,
                           &(struct occlusion){ .ray = &ray,
                                                .tmax = length,
                                                .light = -1,
                                                .spread = gather_spread });
}

/* What a side gets that is turned a little. Where the corner gets less than its
 * light by direction says, as under a ball that lies on a floor, what hides it
 * from that hides as much of what the turn brings or takes: all of it taken
 * would leave black spots there. No less than nothing. */
static double turned_by(double share, double here, double turned)
{
    double seen = here > 0 ? fmin(share / here, 1) : 1;
    return fmax(share + seen * (turned - here), 0);
}

struct indirect_share corner_share(const struct corner *corner,
                                   const struct corner_light *light,
                                   const struct receiver *receiver)
{
    struct indirect_share share = light->share;
    if (vec3_dot(receiver->normal, corner->side) >= indirect_pixels_flat)
        return share;
    const struct indirect_share here = indirect_light_share(&light->light,
                                                            corner->side),
                                turned = indirect_light_bumped(
                                    &light->light, receiver->side,
                                    receiver->smooth, receiver->normal);
    share.light.r = turned_by(share.light.r, here.light.r, turned.light.r);
    share.light.g = turned_by(share.light.g, here.light.g, turned.light.g);
    share.light.b = turned_by(share.light.b, here.light.b, turned.light.b);
    share.open = fmin(turned_by(share.open, here.open, turned.open), 1);
    return share;
}
