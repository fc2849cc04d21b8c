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
        .world = world, .scene = scene, .quality = quality, .seed = seed
    };
    const struct light *lights = world_lights(world, &lamps.count);
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
};

static rgb lamp_trace(const struct lamp_question *q, vec3 direction,
                      double distance)
{
    const struct lamps *lamps = q->lamps;
    bool fog = q->lamp->light->media_attenuation &&
               lamps->quality >= QUALITY_FOG && lamps->scene->fogs.count > 0;
    struct shadow_path path = {
        .point = q->target->point,
        .direction = direction,
        .distance = distance,
        .light = q->lamp->number,
        .inside = q->target->inside,
        .fog = fog ? lamps->scene : NULL,
    };
    return shadow_visibility(lamps->world, q->worker, &path);
}

/* Parallel light comes from the grid moved to stand over the point. */
static rgb lamp_see(void *context, vec3 location)
{
    const struct lamp_question *q = context;
    const struct lamp_view *view = &q->target->view;
    vec3 offset = vec3_sub(location, q->target->point);
    if (worker_stopped(q->worker))
        return rgb_grey(0);
    if (lamp_is_parallel(q->lamp))
        offset = vec3_along(vec3_sub(location, q->lamp->light->location),
                            view->direction, view->distance);
    return lamp_trace(q, vec3_normalise(offset), vec3_length(offset));
}

static bool lamp_casts(const struct lamps *lamps, const struct lamp *lamp)
{
    return !lamp->light->shadowless && lamps->quality >= QUALITY_SHADOWS;
}

rgb lamps_share_point(const struct lamps *lamps, const struct lamp *lamp,
                      struct worker *worker, const struct lamp_target *target)
{
    const struct lamp_view *view = &target->view;
    struct lamp_question question = { lamps, lamp, worker, target };
    if (!lamp_casts(lamps, lamp))
        return rgb_grey(1);
    return lamp_trace(&question, view->direction, view->distance);
}

static rgb lamps_share_grid(const struct lamps *lamps, const struct lamp *lamp,
                            struct worker *worker,
                            const struct lamp_target *target, bool refined)
{
    struct lamp_question question = { lamps, lamp, worker, target };
    if (!lamp_casts(lamps, lamp) || !lamps_soft(lamps, lamp))
        return lamps_share_point(lamps, lamp, worker, target);
    struct area_grid grid = area_grid_new(lamp, target->point, lamps->seed);
    rgb arriving = rgb_scale(lamp->light->colour, target->view.attenuation);
    if (refined)
        area_grid_refine(&grid);
    return area_visibility(&grid, arriving, lamp_see, &question);
}

rgb lamps_share(const struct lamps *lamps, const struct lamp *lamp,
                struct worker *worker, const struct lamp_target *target)
{
    return lamps_share_grid(lamps, lamp, worker, target, false);
}

rgb lamps_share_fine(const struct lamps *lamps, const struct lamp *lamp,
                     struct worker *worker, const struct lamp_target *target)
{
    return lamps_share_grid(lamps, lamp, worker, target, true);
}
