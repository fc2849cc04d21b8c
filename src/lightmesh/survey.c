/* A few gather rays: see survey.h. */
#include "lightmesh/survey.h"

#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* How it is looked: from edge x edge places of the picture, along so many rays
 * each, of which some go to bright places, if these are known. */
struct look {
    int edge, rays;
    const struct bright *bright; /* or NULL */
};

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
    size_t hit;              /* of the rays that were followed: */
    struct bright_hit *hits; /* room for all */
    struct bright_found found;
};

static void sums_hit(struct sums *sums, const struct ray *ray,
                     const struct gathered_ray *found, rgb light)
{
    double distance = found->at.leaf ? found->at.t : survey_far;
    sums->hits[sums->hit++] = (struct bright_hit){
        .from = ray->origin,
        .place = vec3_along(ray->origin, ray->direction, distance),
        .light = fmax(rgb_brightness(light), 0),
    };
}

/* What glows is picked, not found by chance: it is none of the roughness. */
static rgb gathered_rest(const struct gather *gather,
                         const struct gathered_ray *found)
{
    return emitters_any(gather->emitters) ? rgb_sub(found->light, found->glow)
                                          : found->light;
}

/* The rays of one place. */
struct sight_rays {
    const struct sight *sight;
    struct aim aim;
    double aimed; /* share of them */
    int which;    /* place this one is aimed at; -1: none */
};

static struct sight_rays sight_rays_new(const struct sight *sight,
                                        const struct bright *bright)
{
    struct sight_rays rays = { .sight = sight };
    if (!bright || bright->count == 0)
        return rays;
    aim_take(&rays.aim, bright, sight->surface.point);
    rays.aimed = (double)BRIGHT_RAYS / WALL_PART;
    return rays;
}

/* Which way ray `draws` goes; *counts so much more than if all went alike
 * (balance heuristic); 0: there is nothing to be seen from the surface. */
static vec3 sight_way(struct sight_rays *rays, const struct draws *draws,
                      double *counts)
{
    vec3 side = rays->sight->surface.side;
    bool aimed = rays->aimed > 0 && draws->index % WALL_PART < BRIGHT_RAYS;
    double u[2];
    rays->which = -1;
    draw_pair(draws, GATHER_DIRECTION, u);
    vec3 way =
        aimed ? aim_way(&rays->aim, u, &rays->which) : warp_lobe(u, side, 1);
    double even = fmax(vec3_dot(way, side), 0) / WARP_PI;
    *counts = aimed && even == 0 ? 0 : 1;
    if (rays->aimed > 0 && even > 0)
        *counts = even / ((1 - rays->aimed) * even +
                          rays->aimed * aim_density(&rays->aim, way));
    return way;
}

static void sight_gather(const struct sight *sight, const struct gather *gather,
                         struct worker *worker, struct draws draws,
                         const struct look *look, struct sums *sums)
{
    double sum = 0, squares = 0, changed = 0;
    double ambient = rgb_brightness(sight->ambient);
    struct sight_rays rays = sight_rays_new(sight, look->bright);
    draws.index *= (uint32_t)look->rays;
    for (int i = 0; i < look->rays; i++, draws.index++) {
        struct gathered_ray found;
        double counts;
        vec3 way = sight_way(&rays, &draws, &counts);
        if (counts == 0)
            continue;
        struct ray ray = { sight->surface.point, way };
        gather_radiance(gather, worker, &ray, &draws, &found);
        rgb rest = gathered_rest(gather, &found);
        double brought = rgb_brightness(rgb_mul(sight->albedo, rest));
        sums_hit(sums, &ray, &found, rest);
        if (rays.which >= 0) {
            sums->found.rays[rays.which]++;
            sums->found.light[rays.which] += rgb_brightness(rest);
        }

        double whole = counts * (brought + ambient * found.open);
        sum += whole;
        squares += whole * whole;
        changed += rgb_brightness(rgb_mul(sight->albedo, found.light)) +
                   ambient * (1 - fmin(found.open, 1));
        sums->light = rgb_add(sums->light, found.light);
        sums->open += fmin(found.open, 1);
        sums->ends += rgb_peak(found.glow) > 0 ? 1 : fmin(found.open, 1);
    }
    double mean = sum / look->rays;
    double spread = (squares - sum * mean) / (look->rays - 1);
    double shown = fmax(sight->shown, 0) + mean + survey_dark;
    sums->rays += look->rays;
    sums->worth += changed / look->rays / shown;
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
    return (struct survey){ .worth = 1, .rough = 48 * gather_noise };
}

static void sums_look(struct sums *sums, const struct gather *gather,
                      const struct scene *scene, struct worker *worker,
                      const struct look *look)
{
    int places = look->edge * look->edge;
    struct sight sight;
    *sums = (struct sums){
        .hits = memory_new((size_t)(places * look->rays) * sizeof *sums->hits),
    };
    for (int i = 0; i < places; i++) {
        struct draws draws = { gather->lamps->seed, (uint32_t)i };
        double x = (i % look->edge + 0.5) / look->edge,
               y = (i / look->edge + 0.5) / look->edge;
        if (worker_stopped(worker) ||
            !sight_find(&sight, gather, &scene->camera, x, y))
            continue;
        sums->sights++;
        sight_light(&sight, gather, worker, &draws);
        sight_gather(&sight, gather, worker, draws, look, sums);
        arena_reset(worker->scratch);
    }
}

static double sums_rough(const struct sums *sums)
{
    return sums->sights > 0 ? sqrt(sums->rough / sums->sights) : 0;
}

/* One ray differs so much from another. Places are learnt from those that were
 * aimed at them, if any. */
static double survey_look(struct survey *survey, const struct gather *gather,
                          const struct scene *scene, struct worker *worker,
                          int rays)
{
    const struct look look = { SURVEY_FINE, rays, &survey->bright };
    bool aims = survey->bright.count > 0;
    struct sums sums;
    sums_look(&sums, gather, scene, worker, &look);
    if (aims)
        bright_learn(&survey->bright, &sums.found);
    else
        survey->bright = bright_of(sums.hits, sums.hit);
    memory_free(sums.hits);
    return sums_rough(&sums);
}

/* Where most of the light in a chamber comes from takes many rays to see: they
 * are spared where few of each point will do. Some of a point's are sent there
 * if then one of them differs less from another. */
static void survey_aim(struct survey *survey, const struct gather *gather,
                       const struct scene *scene, struct worker *worker)
{
    double aimed = (double)INFINITY;
    if (survey->open >= open_enough || survey->rough < survey_smooth)
        return;
    survey->rough =
        survey_look(survey, gather, scene, worker, SURVEY_FINE_RAYS);
    for (int i = 0; i < SURVEY_AIMED && survey->bright.count > 0; i++)
        aimed = survey_look(survey, gather, scene, worker, SURVEY_RAYS);
    if (aimed < survey_smoother * survey->rough)
        survey->rough = aimed;
    else
        survey->bright.count = 0;
}

struct survey survey_of(const struct gather *gather, const struct scene *scene,
                        struct worker *worker)
{
    const struct look look = { SURVEY_EDGE, SURVEY_RAYS, NULL };
    struct sums sums;
    sums_look(&sums, gather, scene, worker, &look);
    memory_free(sums.hits);
    if (sums.sights == 0)
        return (struct survey){ .open = 1 };
    struct survey survey = {
        .open = sums.ends / sums.rays,
        .worth = sums.worth / sums.sights,
        .rough = sums_rough(&sums),
        .around = sums_around(&sums),
    };
    survey_aim(&survey, gather, scene, worker);
    return survey;
}

void survey_tell(const struct survey *survey, survey_row *row, void *context)
{
    row(context, "survey open", 100 * survey->open, "%");
    row(context, "survey worth", 100 * survey->worth, "%");
    row(context, "survey rough", 100 * survey->rough, "%");
}
