/* POV-Ray's own illumination: one shadow ray for each lamp (a grid of them for
 * area lights) and a constant ambient light. What the other methods are
 * compared with. */
#include "base/memory.h"
#include "lighting/lighting.h"
#include "shade/area.h"
#include "shade/shadow.h"

struct rays {
    const struct world *world;
    const struct scene *scene;
    struct lamp *lamps;
    size_t count;
    rgb ambient;
    int quality;
    uint64_t seed;
};

static void *rays_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    struct rays *rays = memory_new(sizeof *rays);
    const struct light *lights = world_lights(world, &rays->count);
    if (scene->settings.radiosity)
        diag_print(diag, DIAG_WARNING, span_none(), NULL,
                   "--lighting rays ignores the scene's radiosity: to follow "
                   "light on from surface to surface type --lighting path");
    rays->world = world;
    rays->scene = scene;
    rays->ambient = scene->settings.ambient_light;
    rays->quality = options->quality;
    rays->seed = options->seed;
    rays->lamps = memory_new(rays->count * sizeof *rays->lamps);
    for (size_t i = 0; i < rays->count; i++)
        rays->lamps[i] = lamp_new(&lights[i], (int)i);
    return rays;
}

static void rays_finish(void *state)
{
    struct rays *rays = state;
    if (!rays)
        return;
    memory_free(rays->lamps);
    memory_free(rays);
}

/* One surface point looking at one lamp. */
struct rays_question {
    const struct rays *rays;
    const struct lamp *lamp;
    struct worker *worker;
    const struct surface *surface;
    struct lamp_view view; /* of the lamp's centre */
    light_visit *visit;
    void *context;
};

static rgb rays_trace(const struct rays_question *q, vec3 direction,
                      double distance)
{
    const struct rays *rays = q->rays;
    bool fog = q->lamp->light->media_attenuation &&
               rays->quality >= QUALITY_FOG && rays->scene->fogs.count > 0;
    struct shadow_path path = {
        .point = q->surface->point,
        .direction = direction,
        .distance = distance,
        .light = q->lamp->number,
        .inside = q->surface->inside,
        .fog = fog ? rays->scene : NULL,
    };
    return shadow_visibility(rays->world, q->worker, &path);
}

/* Parallel light comes from the grid moved to stand over the point. */
static rgb rays_see(void *context, vec3 location)
{
    const struct rays_question *q = context;
    const struct light *light = q->lamp->light;
    vec3 offset = vec3_sub(location, q->surface->point);
    if (worker_stopped(q->worker))
        return rgb_grey(0);
    if (lamp_is_parallel(q->lamp))
        offset = vec3_along(vec3_sub(location, light->location),
                            q->view.direction, q->view.distance);
    return rays_trace(q, vec3_normalise(offset), vec3_length(offset));
}

static bool rays_area(const struct rays_question *q)
{
    return q->lamp->light->area && q->rays->quality >= QUALITY_AREA_LIGHTS;
}

/* The share of the lamp that is not in shadow. */
static rgb rays_visibility(struct rays_question *q)
{
    const struct light *light = q->lamp->light;
    const struct rays *rays = q->rays;
    vec3 point = q->surface->point;
    if (light->shadowless || rays->quality < QUALITY_SHADOWS)
        return rgb_grey(1);
    if (!rays_area(q))
        return rays_trace(q, q->view.direction, q->view.distance);
    struct area_grid grid = area_grid_new(q->lamp, point, rays->seed);
    rgb arriving = rgb_scale(light->colour, q->view.attenuation);
    return area_visibility(&grid, arriving, rays_see, q);
}

static void rays_give(const struct rays_question *q,
                      const struct lamp_view *view, rgb share)
{
    const struct light *light = q->lamp->light;
    struct light_sample sample = {
        .direction = view->direction,
        .colour = rgb_mul(rgb_scale(light->colour, view->attenuation), share),
        .highlights = !light->shadowless,
    };
    q->visit(q->context, &sample);
}

/* area_illumination: the plain mean over the grid, unshadowed, times the
 * weighted mean of the shadows (POV-Ray's formula, measured). */
static void rays_give_area(struct rays_question *q)
{
    const struct light *light = q->lamp->light;
    vec3 point = q->surface->point;
    struct area_grid grid = area_grid_new(q->lamp, point, q->rays->seed);
    struct lamp_view view;
    rgb share = rays_visibility(q);
    if (rgb_peak(share) == 0)
        return;
    share = rgb_scale(share, 1.0 / ((double)light->size1 * light->size2));
    for (int i = 0; i < light->size1; i++)
        for (int j = 0; j < light->size2 && !worker_stopped(q->worker); j++)
            if (lamp_look(q->lamp, area_grid_point(&grid, i, j), point, &view))
                rays_give(q, &view, share);
}

static void rays_answer(struct rays_question *q)
{
    const struct light *light = q->lamp->light;
    bool there =
        lamp_look(q->lamp, light->location, q->surface->point, &q->view);
    if (light->area_illumination && rays_area(q)) {
        rays_give_area(q);
        return;
    }
    if (!there || !surface_faces(q->surface, q->view.direction))
        return;
    rgb share = rays_visibility(q);
    if (rgb_peak(share) > 0)
        rays_give(q, &q->view, share);
}

static struct diffuse_light rays_illuminate(const void *state,
                                            struct worker *worker,
                                            const struct surface *surface,
                                            light_visit *visit, void *context)
{
    const struct rays *rays = state;
    struct rays_question question = {
        .rays = rays,
        .worker = worker,
        .surface = surface,
        .visit = visit,
        .context = context,
    };
    for (size_t i = 0; i < rays->count; i++) {
        question.lamp = &rays->lamps[i];
        rays_answer(&question);
    }
    return (struct diffuse_light){ .ambient = rays->ambient };
}

const struct lighting rays_lighting = {
    .name = "rays",
    .help = "POV-Ray's own: shadow rays to every light and an ambient term",
    .start = rays_start,
    .finish = rays_finish,
    .illuminate = rays_illuminate,
};
