/* What virtual lights bring of what a survey found: see survey_sums.h. */
#include "lightmesh/survey_sums.h"

#include "base/warp.h"
#include "lightmesh/gather_virtual.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/lit_cells.h"
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
    size_t rays = sums_rays(sums);
    double sum = 0;
    for (size_t i = 0; i < rays; i++)
        sum += hit_sent(&sums->hits[i], lights) * sums->hits[i].lamps;
    return sum;
}

/* All but what they bring. */
static void sums_leave(struct sums *sums, const struct virtual_lights *lights)
{
    size_t rays = sums_rays(sums);
    for (size_t i = 0; i < rays; i++) {
        struct bright_hit *hit = &sums->hits[i];
        double sent = hit_sent(hit, lights);
        hit->light = fmax(hit->light - sent * hit->lamps, 0);
        sums->brought[i].light -= sent * sums->brought[i].lamps;
    }
}

/* The variance of what one of SURVEY_PICKS rays brings to a place that is seen,
 * so many of which met what they were picked for; `times` their densities. */
static double seen_variance(const struct seen *seen,
                            const struct gathered_glow *found, unsigned count,
                            double times)
{
    double sum = 0, squares = 0;
    for (unsigned i = 0; i < count; i++) {
        double cosine = fmax(vec3_dot(found[i].direction, seen->side), 0);
        double brought = rgb_brightness(rgb_mul(seen->shows, found[i].light)) *
                         cosine / (WARP_PI * found[i].density * times);
        sum += brought;
        squares += brought * brought;
    }
    return fmax(squares - sum * sum / SURVEY_PICKS, 0) / (SURVEY_PICKS - 1);
}

static double sums_picked(const struct sums *sums,
                          const struct virtual_lights *lights,
                          struct worker *worker)
{
    struct gather gather = *sums->gather;
    struct gathered_glow found[VIRTUAL_PICKS_MOST];
    double sum = 0;
    gather.virtual_lights = lights;
    gather.picks = SURVEY_PICKS;
    for (int i = 0; i < sums->sights; i++) {
        const struct seen *seen = &sums->seen[i];
        unsigned count = gather_virtual(&gather, worker, seen->place,
                                        (unsigned)i % GATHER_PARTS, found);
        sum += seen_variance(seen, found, count, 1.0 / SURVEY_PICKS);
    }
    return sqrt(sum / sums->sights);
}

double sums_glows(const struct sums *sums, struct worker *worker)
{
    struct gathered_glow found[RAY_LANES];
    struct draws draws[SURVEY_PICKS];
    double sum = 0;
    if (!emitters_any(sums->gather->emitters))
        return 0;
    for (int i = 0; i < sums->sights; i++) {
        const struct seen *seen = &sums->seen[i];
        for (int k = 0; k < SURVEY_PICKS; k++)
            draws[k] = (struct draws){ sums->gather->lamps->seed,
                                       (uint32_t)(i * SURVEY_PICKS + k) };
        unsigned count = gather_pick(sums->gather, worker, seen->place, draws,
                                     SURVEY_PICKS, found);
        sum += seen_variance(seen, found, count, 1);
    }
    return sqrt(sum / sums->sights);
}

/* Those of some cells, and what they bring. */
struct lit {
    struct bright cells;
    struct virtual_lights *lights; /* NULL: none */
    double sent;
};

static struct lit lit_new(const struct sums *sums, const struct bright *cells,
                          int times, struct worker *worker)
{
    struct lit lit = { .cells = *cells };
    if (cells->count == 0)
        return lit;
    lit.lights = virtual_lights_new(cells, sums->gather->lamps, times, worker);
    lit.sent = sums_sent(sums, lit.lights);
    return lit;
}

static struct lit sums_lit(const struct sums *sums,
                           const struct survey_options *options,
                           struct worker *worker)
{
    const struct bright found = sums_cells(sums, lit_cells_of);
    struct lit lit = lit_new(sums, &found, options->times, worker);
    if (!options->known)
        return lit;
    struct lit known =
        lit_new(sums, &options->known->lit, options->times, worker);
    bool keep = known.sent * bright_known > lit.sent;
    virtual_lights_free((keep ? &lit : &known)->lights);
    return keep ? known : lit;
}

static double sums_light_all(const struct sums *sums)
{
    double all = 0;
    for (size_t i = 0; i < sums_rays(sums); i++)
        all += sums->hits[i].light;
    return all;
}

void sums_light(struct sums *sums, const struct survey_options *options,
                struct worker *worker, struct survey *survey)
{
    if (options->times == 0 || sums->gather->lamps->scene->fogs.count > 0)
        return;
    struct lit lit = sums_lit(sums, options, worker);
    if (lit.sent > virtual_worth * sums_light_all(sums)) {
        survey->lit = lit.cells;
        survey->lights = lit.lights;
    } else {
        virtual_lights_free(lit.lights);
    }
    if (survey->lights) {
        survey->picked = sums_picked(sums, survey->lights, worker);
        sums_leave(sums, survey->lights);
    }
}
