/* What virtual lights bring of what a survey found: see survey_sums.h. */
#include "lightmesh/survey_sums.h"

#include "lightmesh/tuning.h"
#include "lightmesh/virtual_lights.h"

/* What of lamps' light virtual lights bring: of each hit, a share. */
static double hit_sent(const struct bright_hit *hit,
                       const struct virtual_lights *lights)
{
    return hit->lamps > 0 ? virtual_lights_share(lights, bright_hit_place(hit),
                                                 hit->normal, hit->distance)
                          : 0;
}

static double sums_sent(const struct sums *sums,
                        const struct virtual_lights *lights)
{
    size_t rays = (size_t)sums->sights * (size_t)sums->each;
    double sum = 0;
    for (size_t i = 0; i < rays; i++)
        sum += hit_sent(&sums->hits[i], lights) * sums->hits[i].lamps;
    return sum;
}

/* All but what they bring. */
static void sums_leave(struct sums *sums, const struct virtual_lights *lights)
{
    size_t rays = (size_t)sums->sights * (size_t)sums->each;
    for (size_t i = 0; i < rays; i++) {
        struct bright_hit *hit = &sums->hits[i];
        double sent = hit_sent(hit, lights);
        hit->light = fmax(hit->light - sent * hit->lamps, 0);
        sums->brought[i].light -= sent * sums->brought[i].lamps;
    }
}

struct bright sums_lit(struct sums *sums, const struct bright *known,
                       struct worker *worker)
{
    const struct lamps *lamps = sums->gather->lamps;
    struct bright lit = { .count = 0 }, found = sums_bright(sums);
    double all = 0, sent, before = 0;
    struct virtual_lights *lights, *older = NULL;
    if (found.count == 0 || lamps->scene->fogs.count > 0)
        return lit;
    for (size_t i = 0; i < (size_t)sums->sights * (size_t)sums->each; i++)
        all += sums->hits[i].light;
    lights = virtual_lights_new(&found, lamps, 1, worker);
    sent = sums_sent(sums, lights);
    if (known) {
        older = virtual_lights_new(known, lamps, 1, worker);
        before = sums_sent(sums, older);
    }
    bool keep = before * bright_known > sent;
    if (fmax(sent, before) > virtual_worth * all) {
        sums_leave(sums, keep ? older : lights);
        lit = keep ? *known : found;
    }
    virtual_lights_free(lights);
    virtual_lights_free(older);
    return lit;
}
