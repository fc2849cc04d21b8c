/* A few gather rays: see survey.h. */
#include "lightmesh/survey_sums.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/survey_place.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* A place that the camera sees. */
struct sight {
    struct survey_place at;
    rgb albedo, ambient; /* what it makes of irradiance and ambient light 1 */
    rgb returned;        /* and what other surfaces get of irradiance */
    double shown;        /* brightness without what is gathered */
};

static void sight_light(struct sight *sight, const struct gather *gather,
                        struct worker *worker, const struct draws *draws)
{
    const struct surface *surface = &sight->at.surface;
    const struct lit_place place = { surface->point, surface->normal,
                                     surface->at->leaf,
                                     texture_finish(surface->at->texture) };
    rgb direct =
        drawn_lamp_light(gather->lamps, worker, draws, GATHER_LAMP, &place);
    sight->albedo = surface_albedo(surface);
    sight->returned = surface_returned(surface);
    sight->ambient = rgb_mul(surface_ambient(surface), gather->ambience->light);
    rgb shown = rgb_add(rgb_mul(sight->albedo, direct), surface_shine(surface));
    sight->shown = rgb_brightness(rgb_add(shown, surface_glow(surface)));
}

/* Whether what it met may be a wall: some of others' light comes back from
 * there, or would. A sky that is a sphere, be it day or night, is none. */
static bool gathered_wall(const struct sums *sums, const struct ray *ray,
                          const struct gathered_ray *found)
{
    struct surface surface;
    if (!found->at.leaf)
        return false;
    if (rgb_peak(found->light) > 0 && !(rgb_peak(found->glow) > 0))
        return true;
    gather_surface(sums->gather, ray, &found->at, &surface);
    for (int i = 0; i < surface.count; i++) {
        const struct finish *finish = surface.layer[i].finish;
        if (finish->diffuse > 0 || finish->diffuse_back > 0 ||
            rgb_peak(surface.layer[i].reflection) > 0)
            return true;
    }
    return rgb_peak(surface_passed(&surface)) > 0;
}

static struct bright_hit
gathered_hit(const struct ray *ray, const struct gathered_ray *found, bool wall)
{
    struct bright_hit hit = { .origin = ray->origin,
                              .direction = ray->direction,
                              .distance = HUGE_VAL,
                              .light = 0 };
    if (!wall)
        return hit;
    hit.normal = vec3_against(found->at.face, ray->direction);
    hit.distance = found->at.t;
    return hit;
}

/* How much of it goes no further: it leaves the scene, glows, or is lost. */
static double gathered_ends(const struct gathered_ray *found, bool wall)
{
    bool lost = found->at.leaf && !wall && !(rgb_peak(found->light) > 0);
    return lost || rgb_peak(found->glow) > 0 ? 1 : fmin(found->open, 1);
}

/* The same; where some goes on light stays. */
static double sums_ends(struct sums *sums, const struct gathered_ray *found,
                        bool wall)
{
    const double ends = gathered_ends(found, wall);
    sums->stays |= ends < 1;
    return ends;
}

/* Adds what comes through from the far side of leaves, by a ray that is
 * mirrored; returns what of it isn't picked. */
static rgb sight_add_behind(const struct sight *sight, struct sums *sums,
                            struct worker *worker, struct ray ray,
                            const struct draws *draws,
                            struct gathered_ray *found)
{
    const struct surface *surface = &sight->at.surface;
    double behind = surface_behind(surface);
    struct gathered_ray more;
    if (!(behind > 0))
        return rgb_grey(0);
    double along = vec3_dot(ray.direction, surface->side);
    double density = along / WARP_PI;
    ray.direction = vec3_along(ray.direction, surface->side, -2 * along);
    gather_radiance(sums->gather, worker, &ray, draws, &more);
    sums_ends(sums, &more, gathered_wall(sums, &ray, &more));
    found->light = rgb_add_scaled(found->light, more.light, behind);
    return rgb_scale(gather_balanced(sums->gather, &ray, density, 1, &more),
                     behind);
}

/* What the picture shows of so much light. */
static double sight_brought(const struct sight *sight, rgb light, double open)
{
    return rgb_brightness(rgb_mul(sight->albedo, light)) +
           rgb_brightness(sight->ambient) * open;
}

static void sight_gather(const struct sight *sight, struct worker *worker,
                         struct draws draws, struct sums *sums)
{
    double brought = 0, changed = 0, bounced = 0;
    double ambient = rgb_brightness(sight->ambient);
    size_t first = sums_rays(sums);
    draws.index *= (uint32_t)sums->each;
    for (int i = 0; i < sums->each; i++, draws.index++) {
        struct gathered_ray found;
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
        struct ray ray = { sight->at.surface.point,
                           warp_lobe(u, sight->at.surface.side, 1) };
        sums->sent -= (double)worker->counters.shadow_rays;
        gather_radiance(sums->gather, worker, &ray, &draws, &found);
        sums->sent += (double)worker->counters.shadow_rays;
        bool wall = gathered_wall(sums, &ray, &found);
        sums->ends += sums_ends(sums, &found, wall);
        struct bright_hit *hit = &sums->hits[first + (size_t)i];
        *hit = gathered_hit(&ray, &found, wall);
        hit->lamps = rgb_brightness(rgb_mul(sight->albedo, found.lamps));
        double density =
            vec3_dot(ray.direction, sight->at.surface.side) / WARP_PI;
        rgb rest = gather_balanced(sums->gather, &ray, density, 1, &found);
        hit->light = fmax(sight_brought(sight, rest, found.open), 0);
        rest = rgb_add(
            rest, sight_add_behind(sight, sums, worker, ray, &draws, &found));
        double whole = sight_brought(sight, rest, found.open);
        sums->brought[first + (size_t)i] =
            (struct brought){ whole, density, hit->lamps };
        brought += whole;
        double closed = ambient * (1 - fmin(found.open, 1));
        changed += rgb_brightness(rgb_mul(sight->albedo, found.light)) + closed;
        bounced += rgb_brightness(rgb_mul(sight->albedo, rest)) + closed;
        sums->light = rgb_add(sums->light, found.light);
        sums->open += fmin(found.open, 1);
    }
    double mean = brought / sums->each;
    double shown = fmax(sight->shown, 0) + mean + survey_dark;
    for (int i = 0; i < sums->each; i++) {
        sums->brought[first + (size_t)i].light /= shown;
        sums->brought[first + (size_t)i].lamps /= shown;
    }
    sums->worth += changed / sums->each / shown;
    sums->bounced += bounced / sums->each / shown;
    sums->returned += rgb_brightness(sight->returned);
    sums->seen[sums->sights++] =
        (struct seen){ sight->at.surface.point, sight->at.surface.side,
                       rgb_scale(sight->albedo, 1 / shown) };
}

/* The variance of what one ray brings to a place, if some are aimed: as those
 * that were sent everywhere tell (Veach 1997, section 2.2). Rays that have
 * chosen where to aim would find it better than it is: what they met is aimed
 * at, what is as bright and was missed isn't. */
static double sight_variance(const struct sums *sums, int sight,
                             const struct bright *bright)
{
    size_t first = (size_t)sight * (size_t)sums->each;
    int count = sums->each - sums->choosing;
    double sum = 0, squares = 0;
    struct aim aim;
    aim_take(&aim, bright, sums->hits[first].origin, AIM_RAYS_MOST);
    double aimed = aim.count > 0 ? 1.0 / BRIGHT_PART : 0;
    for (int i = sums->choosing; i < sums->each; i++) {
        size_t ray = first + (size_t)i;
        const struct brought *brought = &sums->brought[ray];
        double more = aimed > 0 ? aim_density(&aim, sums->hits[ray].direction) /
                                      (aim.rays * brought->even)
                                : 0;
        sum += brought->light;
        squares += brought->light * brought->light / (1 - aimed + aimed * more);
    }
    return fmax(squares - sum * sum / count, 0) / (count - 1);
}

static double sums_variance(const struct sums *sums,
                            const struct bright *bright)
{
    double sum = 0;
    for (int i = 0; i < sums->sights; i++)
        sum += sight_variance(sums, i, bright);
    return sum / sums->sights;
}

/* How much rays differ: less if some go to what is bright, or else nothing is.
 */
static double sums_rough(const struct sums *sums, const struct bright *known,
                         struct bright *bright)
{
    const struct bright none = { .count = 0 };
    double variance = sums_variance(sums, &none);
    double aimed = bright->count > 0 ? sums_variance(sums, bright) : variance;
    if (aimed >= bright_gain * variance) {
        *bright = none;
        aimed = variance;
    }
    double before = known ? sums_variance(sums, known) : HUGE_VAL;
    if (before > bright_known * aimed)
        return sqrt(aimed);
    *bright = *known;
    return sqrt(before);
}

/* Light goes on from surface to surface: a geometric series. */
static struct indirect_share sums_around(const struct sums *sums)
{
    double rays = (double)sums->sights * sums->each;
    double open = sums->open / rays;
    double returned = sums->returned / sums->sights;
    double again = fmin(returned * (1 - open), RETURNED_MOST);
    return (struct indirect_share){
        rgb_scale(sums->light, 1 / (rays * (1 - again))), open
    };
}

struct survey survey_none(void)
{
    double rough = gather_noise * pow(UNSEEN_SAMPLES, 1 / gather_net);
    return (struct survey){
        .closed = true, .worth = 1, .bounced = 1, .rough = rough
    };
}

static void sums_gather(struct sums *sums, const struct scene *scene,
                        struct worker *worker)
{
    struct sight sight;
    for (int i = 0; i < SURVEY_EDGE * SURVEY_EDGE; i++) {
        struct draws draws = { sums->gather->lamps->seed, (uint32_t)i };
        double x = (i % SURVEY_EDGE + 0.5) / SURVEY_EDGE,
               y = (i / SURVEY_EDGE + 0.5) / SURVEY_EDGE;
        if (worker_stopped(worker) ||
            !survey_place_find(&sight.at, sums->gather, &scene->camera, x, y))
            continue;
        sight_light(&sight, sums->gather, worker, &draws);
        sight_gather(&sight, worker, draws, sums);
        arena_reset(worker->scratch);
    }
}

struct bright sums_cells(const struct sums *sums, hits_cells *of)
{
    size_t each = (size_t)sums->choosing, count = 0;
    struct bright_hit *hits =
        memory_new((size_t)sums->sights * each * sizeof *hits);
    for (int i = 0; i < sums->sights; i++, count += each)
        memcpy(hits + count, &sums->hits[(size_t)i * (size_t)sums->each],
               each * sizeof *hits);
    struct bright cells = of(hits, count);
    memory_free(hits);
    return cells;
}

/* Whether most light stays (survey.h). The frames of an animation stay on the
 * side of the limits that the first one was on as long as they are near them:
 * light would jump. */
static bool sums_closed(const struct sums *sums, const struct survey *survey,
                        const struct survey *known)
{
    const struct bright none = { .count = 0 };
    double stays = !known          ? 1
                   : known->closed ? half_open_stays
                                   : 1 / half_open_stays;
    return survey->open < open_enough ||
           (survey->open < half_open * stays &&
            survey->worth * stays > half_open_worth &&
            sqrt(sums_variance(sums, &none)) * stays > half_open_rough);
}

static void sums_remember(const struct sums *sums, struct survey *survey)
{
    size_t rays = sums_rays(sums);
    size_t step = rays / SURVEY_HITS + 1;
    for (size_t i = step / 2; i < rays; i += step)
        if (sums->hits[i].distance < HUGE_VAL)
            survey->hit[survey->hits++] = sums->hits[i];
}

static int distances_order(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void sums_sights(const struct sums *sums, struct survey *survey)
{
    double distance[BRIGHT_RAYS];
    const size_t each = (size_t)sums->each,
                 count = each < BRIGHT_RAYS ? each : BRIGHT_RAYS;
    survey->sights = sums->sights;
    for (int i = 0; i < sums->sights; i++) {
        for (size_t j = 0; j < count; j++)
            distance[j] = sums->hits[(size_t)i * each + j].distance;
        qsort(distance, count, sizeof *distance, distances_order);
        survey->sight[i] =
            (struct survey_sight){ sums->seen[i].place,
                                   distance[(count + 1) / 2 - 1] };
    }
}

static struct survey sums_tell(struct sums *sums,
                               const struct survey_options *options,
                               struct worker *worker)
{
    double rays = (double)sums->sights * sums->each;
    const struct survey *known = options->known;
    struct survey survey = { .open = 1 };
    if (sums->sights == 0)
        return survey;
    survey.open = sums->ends / rays;
    survey.stays = sums->stays;
    survey.sent = sums->sent / rays;
    survey.worth = sums->worth / sums->sights;
    survey.bounced = sums->bounced / sums->sights;
    survey.around = sums_around(sums);
    sums_remember(sums, &survey);
    sums_sights(sums, &survey);
    if (options->times > 0)
        survey.glows = sums_glows(sums, worker);
    survey.closed = sums_closed(sums, &survey, known);
    if (survey.closed) {
        sums->choosing = sums->each / 2;
        sums_light(sums, options, worker, &survey);
        survey.bright = sums_cells(sums, bright_of);
    } else {
        known = NULL;
    }
    survey.rough =
        sums_rough(sums, known ? &known->bright : NULL, &survey.bright);
    return survey;
}

struct survey survey_of(const struct gather *gather, const struct scene *scene,
                        struct worker *worker,
                        const struct survey_options *options)
{
    enum { SIGHTS = SURVEY_EDGE * SURVEY_EDGE };
    _Static_assert(SIGHTS <= (int)SURVEY_SIGHTS, "a survey keeps all sights");
    struct sums sums = { .gather = gather, .each = options->rays };
    size_t rays = SIGHTS * (size_t)options->rays;
    sums.hits = memory_new(rays * sizeof *sums.hits);
    sums.brought = memory_new(rays * sizeof *sums.brought);
    sums.seen = memory_new(SIGHTS * sizeof *sums.seen);
    sums_gather(&sums, scene, worker);
    struct survey survey = sums_tell(&sums, options, worker);
    memory_free(sums.hits);
    memory_free(sums.brought);
    memory_free(sums.seen);
    return survey;
}

void survey_tell(const struct survey *survey, survey_row *row, void *context)
{
    row(context, "survey open", 100 * survey->open, "%");
    row(context, "survey worth", 100 * survey->worth, "%");
    row(context, "survey rough", 100 * survey->rough, "%");
}
