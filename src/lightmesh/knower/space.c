/* Mesh points in space, around the receiver (direct.h). Of few lamps each point
 * knows each one's share; where neighbours differ there is an edge between
 * them, and shadow rays are asked for a sharp one. */
#include "lightmesh/knower.h"
#include "lightmesh/tuning.h"

static double space_cost(const struct knower_job *job)
{
    double more = fmin(fmax(job->lamps / pixel_lamps_more, 1), pixel_more_most);
    return job->pixels * time_space_pixel * more * job->finer;
}

static const struct asking_side *space_side(struct asking *asking, bool behind)
{
    struct asking_side *side = &asking->side[behind];
    const struct direct_mesh *mesh = asking->knowers->direct;
    struct receiver receiver = asking->receiver;
    if (side->known)
        return side;
    side->known = true;
    if (behind)
        receiver.side = vec3_negate(receiver.side);
    point_mesh_blend(&mesh->points, asking->worker, &receiver, &side->blend);
    direct_mesh_judge(mesh, &side->blend, &side->verdict);
    return side;
}

/* Area lights have soft shadows without it. */
static bool space_knows(const struct asking *asking, const struct lamp *lamp)
{
    const struct knowers *knowers = asking->knowers;
    return knowers->plan->lamps == PLAN_SETTLED ||
           (knowers->plan->lamps == PLAN_BLENDED &&
            !lamps_soft(knowers->lamps, lamp));
}

static bool space_one_lamp(struct asking *asking, const struct lamp *lamp,
                           const struct lamp_view *view, rgb *share)
{
    const struct direct_mesh *mesh = asking->knowers->direct;
    if (!space_knows(asking, lamp))
        return false;
    *share = rgb_grey(1);
    if (lamp->light->shadowless)
        return true;
    const struct asking_side *side = space_side(
        asking, vec3_dot(view->direction, asking->receiver.side) < 0);
    bool lit = few_has(side->verdict.lit, lamp->number);
    bool certain = (lit || few_has(side->verdict.dark, lamp->number)) &&
                   direct_mesh_agrees(&side->blend);
    if (asking->knowers->plan->lamps == PLAN_SETTLED && !certain &&
        !few_has(side->verdict.faint, lamp->number))
        return false;
    if (!lit)
        *share = direct_mesh_share(mesh, &side->blend, lamp->number);
    return true;
}

bool asking_rules_out(struct asking *asking, const struct lamp *lamp)
{
    if (!space_knows(asking, lamp))
        return false;
    const struct asking_side *front = space_side(asking, false);
    return few_has(front->verdict.dark, lamp->number) &&
           (asking->knowers->plan->lamps != PLAN_SETTLED ||
            direct_mesh_agrees(&front->blend));
}

static bool space_all_lamps(struct asking *asking, struct incident *incident)
{
    struct mesh_blend *blend = &asking->side[0].blend;
    point_mesh_blend(&asking->knowers->direct->points, asking->worker,
                     &asking->receiver, blend);
    incident->around = true;
    incident->in_space = direct_mesh_light(blend);
    return true;
}

const struct knower space_knower = {
    .name = "space",
    .help = "mesh points around",
    .cost = space_cost,
    .one_lamp = space_one_lamp,
    .all_lamps = space_all_lamps,
};
