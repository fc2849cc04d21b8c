/* The ladder: see knower.h. */
#include "lightmesh/knower.h"

#include "base/telling.h"
#include "lightmesh/tuning.h"

#define X(name) extern const struct knower name##_knower;
#include "lightmesh/knower/list.h"
#undef X

static const struct knower *const ladder[] = {
#define X(name) &name##_knower,
#include "lightmesh/knower/list.h"
#undef X
};

enum { KNOWERS = sizeof ladder / sizeof *ladder };

const struct knower *knower_at(size_t index)
{
    return index < KNOWERS ? ladder[index] : NULL;
}

void asking_start(struct asking *asking, const struct knowers *knowers,
                  struct worker *worker, const struct receiver *receiver,
                  const struct interiors *inside)
{
    asking->knowers = knowers;
    asking->worker = worker;
    asking->receiver = *receiver;
    asking->inside = inside;
    asking->side[0].known = asking->side[1].known = false;
}

rgb asking_one_lamp(struct asking *asking, const struct lamp *lamp,
                    const struct lamp_view *view)
{
    rgb share = rgb_grey(0);
    unsigned long long rays = asking->worker->counters.shadow_rays;
    for (int i = 0; i < KNOWERS; i++) {
        if (!ladder[i]->one_lamp ||
            !ladder[i]->one_lamp(asking, lamp, view, &share))
            continue;
        asking->answered = i;
        if (asking->worker->telling)
            telling_answer(asking->worker->telling, ladder[i]->name,
                           "lamp %d: %.4g %.4g %.4g of its light, by %s (%s), "
                           "%llu rays",
                           lamp->number + 1, share.r, share.g, share.b,
                           ladder[i]->name, ladder[i]->help,
                           asking->worker->counters.shadow_rays - rays);
        break;
    }
    return share;
}

void asking_all_lamps(struct asking *asking, struct incident *incident)
{
    unsigned long long rays = asking->worker->counters.shadow_rays;
    for (int i = 0; i < KNOWERS; i++) {
        if (!ladder[i]->all_lamps || !ladder[i]->all_lamps(asking, incident))
            continue;
        asking->answered = i;
        if (asking->worker->telling)
            telling_answer(asking->worker->telling, ladder[i]->name,
                           "all %zu lamps: summed by %s (%s), %llu rays",
                           asking->knowers->lamps->count, ladder[i]->name,
                           ladder[i]->help,
                           asking->worker->counters.shadow_rays - rays);
        return;
    }
}

bool knower_pixels_pay(const struct plan *plan, const struct knower_job *job)
{
    double cost = pixels_knower.cost(job);
    if (plan->lamps == PLAN_EACH)
        return cost <= rays_knower.cost(job) * pixel_rays_share;
    return cost <= pixel_worth * space_knower.cost(job);
}
