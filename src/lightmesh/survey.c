/* A few gather rays: see survey.h. */
#include "lightmesh/survey.h"

#include "base/warp.h"
#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

enum { SURVEY_HITS = SURVEY_EDGE * SURVEY_EDGE * SURVEY_RAYS };

/* A place that the camera sees. */
struct sight {
    struct surface surface;
    struct intersection at;
    rgb albedo, ambient; /* what it makes of irradiance and ambient light 1 */
    rgb returned;        /* and what other surfaces get of irradiance */
    double shown;        /* brightness without what is gathered */
};

static bool sight_find(struct sight *sight, const struct gather *gather,
                       const struct camera *camera, double x, double y)
{
    const struct world *world = gather->lamps->world;
    if (!camera_sees(camera, x, y))
        return false;
    struct ray ray = camera_ray(camera, x, y);
    for (int i = 0; i < SURVEY_PANES; i++) {
        if (!world_closest(world, &ray, surface_offset(ray.origin), RAY_CAMERA,
                           &sight->at))
            return false;
        gather_surface(gather, &ray, &sight->at, &sight->surface);
        if (rgb_brightness(sight->surface.through) < 0.5)
            return true;
        ray.origin = sight->at.point;
    }
    return false;
}

static void sight_light(struct sight *sight, const struct gather *gather,
                        struct worker *worker, const struct draws *draws)
{
    const struct surface *surface = &sight->surface;
    rgb direct = drawn_lamp_light(gather->lamps, worker, draws, GATHER_LAMP,
                                  surface->point, surface->normal);
    sight->albedo = surface_albedo(surface);
    sight->returned = surface_returned(surface);
    sight->ambient = rgb_mul(surface_ambient(surface), gather->ambience->light);
    rgb shown = rgb_add(rgb_mul(sight->albedo, direct), surface_shine(surface));
    sight->shown = rgb_brightness(rgb_add(shown, surface_glow(surface)));
}

/* Sums over all gather rays. */
struct sums {
    int sights, rays;
    double open, ends, worth, rough, returned;
    rgb light;
    size_t hit; /* of the rays, surfaces: */
    struct bright_hit hits[SURVEY_HITS];
};

static void sums_hit(struct sums *sums, const struct gathered_ray *found,
                     rgb light)
{
    if (found->at.leaf)
        sums->hits[sums->hit++] =
            (struct bright_hit){ found->at.point,
                                 fmax(rgb_brightness(light), 0) };
}

/* What glows is picked, not found by chance: it is none of the roughness. */
static rgb gathered_rest(const struct gather *gather,
                         const struct gathered_ray *found)
{
    return emitters_any(gather->emitters) ? rgb_sub(found->light, found->glow)
                                          : found->light;
}

static void sight_gather(const struct sight *sight, const struct gather *gather,
                         struct worker *worker, struct draws draws,
                         struct sums *sums)
{
    double sum = 0, squares = 0, changed = 0;
    double ambient = rgb_brightness(sight->ambient);
    draws.index *= SURVEY_RAYS;
    for (int i = 0; i < SURVEY_RAYS; i++, draws.index++) {
        struct gathered_ray found;
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
        struct ray ray = { sight->surface.point,
                           warp_lobe(u, sight->surface.side, 1) };
        gather_radiance(gather, worker, &ray, &draws, &found);
        rgb rest = gathered_rest(gather, &found);
        double brought = rgb_brightness(rgb_mul(sight->albedo, rest));
        sums_hit(sums, &found, rest);
        double whole = brought + ambient * found.open;
        sum += whole;
        squares += whole * whole;
        changed += rgb_brightness(rgb_mul(sight->albedo, found.light)) +
                   ambient * (1 - fmin(found.open, 1));
        sums->light = rgb_add(sums->light, found.light);
        sums->open += fmin(found.open, 1);
        sums->ends += rgb_peak(found.glow) > 0 ? 1 : fmin(found.open, 1);
    }
    double mean = sum / SURVEY_RAYS;
    double spread = (squares - sum * mean) / (SURVEY_RAYS - 1);
    double shown = fmax(sight->shown, 0) + mean + survey_dark;
    sums->rays += SURVEY_RAYS;
    sums->worth += changed / SURVEY_RAYS / shown;
    sums->rough += fmax(spread, 0) / (shown * shown);
    sums->returned += rgb_brightness(sight->returned);
}

/* Light goes on from surface to surface: a geometric series. */
static struct indirect_share sums_around(const struct sums *sums)
{
    double open = sums->open / sums->rays;
    double returned = sums->returned / sums->sights;
    double again = fmin(returned * (1 - open), RETURNED_MOST);
    return (struct indirect_share){
        rgb_scale(sums->light, 1 / (sums->rays * (1 - again))), open
    };
}

struct survey survey_none(void)
{
    double rough = gather_noise * pow(UNSEEN_SAMPLES, 1 / gather_net);
    return (struct survey){ .worth = 1, .rough = rough };
}

struct survey survey_of(const struct gather *gather, const struct scene *scene,
                        struct worker *worker)
{
    struct sums sums = { 0 };
    struct sight sight;
    for (int i = 0; i < SURVEY_EDGE * SURVEY_EDGE; i++) {
        struct draws draws = { gather->lamps->seed, (uint32_t)i };
        double x = (i % SURVEY_EDGE + 0.5) / SURVEY_EDGE,
               y = (i / SURVEY_EDGE + 0.5) / SURVEY_EDGE;
        if (worker_stopped(worker) ||
            !sight_find(&sight, gather, &scene->camera, x, y))
            continue;
        sums.sights++;
        sight_light(&sight, gather, worker, &draws);
        sight_gather(&sight, gather, worker, draws, &sums);
        arena_reset(worker->scratch);
    }
    if (sums.sights == 0)
        return (struct survey){ .open = 1 };
    return (struct survey){
        .open = sums.ends / sums.rays,
        .worth = sums.worth / sums.sights,
        .rough = sqrt(sums.rough / sums.sights),
        .around = sums_around(&sums),
        .bright = bright_of(sums.hits, sums.hit),
    };
}

void survey_tell(const struct survey *survey, survey_row *row, void *context)
{
    row(context, "survey open", 100 * survey->open, "%");
    row(context, "survey worth", 100 * survey->worth, "%");
    row(context, "survey rough", 100 * survey->rough, "%");
}
