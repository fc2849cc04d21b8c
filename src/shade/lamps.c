/* Which lamps a point sees: see lamps.h. */
#include "shade/lamps.h"

#include "base/memory.h"
#include "shade/area.h"
#include "shade/shadow.h"
#include "shade/surface.h"

struct lamps lamps_new(const struct world *world, const struct scene *scene,
                       int quality, uint64_t seed)
{
    struct lamps lamps = {
        .world = world,
        .scene = scene,
        .quality = quality,
        .photons = scene->settings.photons.on && quality >= QUALITY_PHOTONS,
        .seed = seed,
    };
    const struct light *lights = world_lights(world, &lamps.count);
    bool air = quality >= QUALITY_FOG;
    lamps.foggy = air && (scene->fogs.count > 0 || scene->media.count > 0);
    lamps.misty = air && scene->misty;
    lamps.clear = quality >= QUALITY_SHADOWS && !lamps.misty;
    lamps.plain = lamps.clear && world_is_opaque(world);
    lamps.items = memory_new(lamps.count * sizeof *lamps.items);
    for (size_t i = 0; i < lamps.count; i++)
        lamps.items[i] = lamp_new(&lights[i], (int)i);
    return lamps;
}

void lamps_free(struct lamps *lamps)
{
    memory_free(lamps->items);
}

bool lamps_soft(const struct lamps *lamps, const struct lamp *lamp)
{
    return lamp->light->area && lamps->quality >= QUALITY_AREA_LIGHTS;
}

vec3 lamps_location(const struct lamps *lamps, const struct lamp *lamp,
                    vec3 point, const double u[2])
{
    const struct light *light = lamp->light;
    if (!lamps_soft(lamps, lamp))
        return light->location;
    struct area_grid grid = area_grid_new(lamp, point, 0);
    return area_grid_point(&grid, (int)(u[0] * light->size1),
                           (int)(u[1] * light->size2));
}

/* One point looking at one lamp. */
struct lamp_question {
    const struct lamps *lamps;
    const struct lamp *lamp;
    struct worker *worker;
    const struct lamp_target *target;
    const struct shaft *shaft; /* to all of it, or NULL */
    bool clear;                /* where nothing is in it all light comes */
    bool plain;                /* and none where something is */
};

static struct lamp_question lamp_question(const struct lamps *lamps,
                                          const struct lamp *lamp,
                                          struct worker *worker,
                                          const struct lamp_target *target)
{
    return (struct lamp_question){
        .lamps = lamps, .lamp = lamp, .worker = worker, .target = target
    };
}

static struct shadow_path lamp_path(const struct lamps *lamps,
                                    const struct lamp *lamp,
                                    const struct lamp_target *target)
{
    return (struct shadow_path){
        .point = target->point,
        .direction = target->view.direction,
        .distance = target->view.distance,
        .light = lamp->number,
        .inside = target->inside,
        .fog = lamps_dim(lamps, lamp) ? lamps->scene : NULL,
        .misty = lamps->misty,
        .photons =
            lamps->photons && !target->straight ? &lamp->light->photons : NULL,
    };
}

/* `place` is one in the question's shaft. */
static rgb lamp_trace(const struct lamp_question *q, vec3 direction,
                      double distance, const double place[2])
{
    struct shadow_path path = lamp_path(q->lamps, q->lamp, q->target);
    path.direction = direction;
    path.distance = distance;
    path.shaft = q->shaft;
    path.place[0] = place[0];
    path.place[1] = place[1];
    return shadow_visibility(q->lamps->world, q->worker, &path);
}

/* From the point to a place of the lamp. Parallel light comes from the grid
 * moved to stand over the point. */
static vec3 lamp_offset(const struct lamp_question *q, vec3 location)
{
    const struct lamp_view *view = &q->target->view;
    return lamp_is_parallel(q->lamp)
               ? vec3_along(vec3_sub(location, q->lamp->light->location),
                            view->direction, view->distance)
               : vec3_sub(location, q->target->point);
}

static rgb lamp_see(void *context, const struct area_point *point)
{
    const struct lamp_question *q = context;
    if (worker_stopped(q->worker))
        return rgb_grey(0);
    if (q->clear && shaft_clear(q->shaft, point->place))
        return rgb_grey(1);
    vec3 offset = lamp_offset(q, point->location);
    if (q->plain) {
        q->worker->counters.shadow_rays++;
        bool whole =
            shadow_is_whole(q->shaft, point->place, q->target->point, offset);
        return rgb_grey(whole ? 0 : 1);
    }
    return lamp_trace(q, vec3_normalise(offset), vec3_length(offset),
                      point->place);
}

static bool lamp_casts(const struct lamps *lamps, const struct lamp *lamp)
{
    return !lamp->light->shadowless && lamps->quality >= QUALITY_SHADOWS;
}

rgb lamps_share_point(const struct lamps *lamps, const struct lamp *lamp,
                      struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp))
        return rgb_grey(1);
    struct shadow_path path = lamp_path(lamps, lamp, target);
    return shadow_visibility(lamps->world, worker, &path);
}

/* To all places of a lamp with a size. */
static struct shaft_rays lamp_rays(const struct lamp_question *q,
                                   const struct area_grid *grid)
{
    vec3 point = q->target->point;
    struct shaft_rays rays = { .from = point, .tmin = shadow_start(point) };
    rays.middle = vec3_add(point, lamp_offset(q, q->lamp->light->location));
    area_grid_hull(grid, rays.half);
    if (q->target->at) {
        rays.leaf = q->target->at->leaf;
        rays.normal = q->target->at->face;
    }
    return rays;
}

/* What stands between. */
static void lamp_shaft(struct lamp_question *q, const struct area_grid *grid,
                       struct shaft *shaft)
{
    struct shaft_rays rays = lamp_rays(q, grid);
    world_shaft(q->lamps->world, &rays, shaft);
    q->shaft = shaft;
    q->clear = !shaft->crowded && !lamps_dim(q->lamps, q->lamp) &&
               !q->lamps->misty && !q->lamp->light->pane;
    q->plain = q->clear && shaft->plain;
}

static rgb lamp_share(struct lamp_question *q, const struct area_grid *grid,
                      bool fine)
{
    rgb arriving =
        rgb_scale(q->lamp->light->colour, q->target->view.attenuation);
    if (q->clear && q->shaft->count == 0)
        return rgb_grey(1);
    return fine ? area_outline(grid, arriving, !q->shaft->crowded, lamp_see, q)
                : area_visibility(grid, arriving, lamp_see, q);
}

static rgb lamps_share_grid(struct lamp_question *q, bool fine)
{
    struct area_grid grid =
        area_grid_new(q->lamp, q->target->point, q->lamps->seed);
    struct shaft shaft;
    if (fine)
        area_grid_refine(&grid);
    lamp_shaft(q, &grid, &shaft);
    return lamp_share(q, &grid, fine);
}

rgb lamps_share(const struct lamps *lamps, const struct lamp *lamp,
                struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp) || !lamps_soft(lamps, lamp))
        return lamps_share_point(lamps, lamp, worker, target);
    struct lamp_question q = lamp_question(lamps, lamp, worker, target);
    return lamps_share_grid(&q, false);
}

rgb lamps_share_fine(const struct lamps *lamps, const struct lamp *lamp,
                     struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp) || !lamps_soft(lamps, lamp))
        return lamps_share_point(lamps, lamp, worker, target);
    struct lamp_question q = lamp_question(lamps, lamp, worker, target);
    return lamps_share_grid(&q, true);
}

/* A light that turns to each point turns by so little within the piece. */
static void hull_widen(vec3 half[2], const struct light *light, double radius,
                       double distance)
{
    double wider = light->orient ? 1 + 2 * radius / distance : 1;
    for (int k = 0; k < 2; k++)
        half[k] = vec3_scale(half[k], wider);
}

double lamps_blur(const struct lamps *lamps, const struct lamp *lamp,
                  const struct lamp_target *target, double radius, double bend,
                  double enough)
{
    struct lamp_question q = lamp_question(lamps, lamp, NULL, target);
    struct area_grid grid = area_grid_new(lamp, target->point, lamps->seed);
    if (!(target->view.distance > 0))
        return 0;
    area_grid_refine(&grid);
    struct shaft_rays rays = lamp_rays(&q, &grid);
    hull_widen(rays.half, lamp->light, radius, target->view.distance);
    rays.radius = radius;
    rays.bend = bend;
    return world_blur(lamps->world, &rays, enough);
}
