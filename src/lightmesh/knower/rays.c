/* Shadow rays from the receiver itself: who asks them needs nobody else. */
#include "lightmesh/knower.h"
#include "lightmesh/tuning.h"

static double rays_cost(const struct knower_job *job)
{
    return job->pixels * job->lamps * time_ray_together;
}

static bool rays_one_lamp(struct asking *asking, const struct lamp *lamp,
                          const struct lamp_view *view, rgb *share)
{
    const struct receiver *receiver = &asking->receiver;
    const struct intersection *at = receiver->at;
    const struct lamp_target target = {
        .point = receiver->point,
        .inside = asking->inside,
        .view = *view,
        .leaf = at ? at->leaf : NULL,
        .face = at ? at->face : vec3_make(0, 0, 0),
    };
    *share =
        lamps_share_fine(asking->knowers->lamps, lamp, asking->worker, &target);
    return true;
}

const struct knower rays_knower = {
    .name = "rays",
    .help = "shadow rays from here",
    .cost = rays_cost,
    .one_lamp = rays_one_lamp,
};
