/* See gather_lamps.h. */
#include "lightmesh/gather_lamps.h"

#include "lightmesh/tuning.h"

vec3 gather_jitter(const struct draws *draws)
{
    double u[2];
    draw_pair(draws, GATHER_NEAR, u);
    return vec3_make(u[0] - 0.5, u[1] - 0.5,
                     draw_unit(draws, GATHER_HIGH) - 0.5);
}

bool gather_lamps_asks(const struct direct_mesh *direct)
{
    return direct->many || direct->lamps->count > GATHER_LAMPS;
}

rgb gather_lamps(const struct gather *gather, struct worker *worker,
                 const struct draws *draws, bool again,
                 const struct surface *surface, const struct receiver *receiver)
{
    const struct lamps *lamps = gather->lamps;
    const struct lit_place place = { receiver->point, receiver->normal,
                                     surface->at->leaf,
                                     texture_finish(surface->at->texture) };
    struct receiver asked = *receiver;
    asked.view.coarser = HIT_LEVELS;
    if (gather->direct && gather_lamps_asks(gather->direct) &&
        !scene_lamps_choose(lamps->scene))
        return direct_mesh_nearest(gather->direct, worker, &asked,
                                   gather_jitter(draws));
    if (lamps->count <= GATHER_EACH && !again)
        return each_lamp_light(lamps, worker, draws, GATHER_LAMP, &place);
    return drawn_lamp_light(lamps, worker, draws, GATHER_LAMP, &place);
}

void gather_lamps_many(const struct gather *gather, struct worker *worker,
                       struct lit_places *places)
{
    each_lamp_many(gather->lamps, worker, GATHER_LAMP, places);
}
