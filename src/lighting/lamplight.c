/* One lamp's light: see lamplight.h. */
#include "lighting/lamplight.h"

#include "shade/area.h"

static struct lamp_target lamplight_target(const struct lamplight *light,
                                           const struct lamp_view *view)
{
    const struct surface *surface = light->surface;
    return (struct lamp_target){
        .point = surface->point,
        .inside = surface->inside,
        .view = *view,
        .leaf = surface->at->leaf,
        .face = surface->at->face,
    };
}

rgb lamplight_trace(struct lamplight *light, const struct lamp *lamp,
                    const struct lamp_view *view)
{
    if (lamps_plain(light->lamps, lamp))
        return lamps_share_plain(light->lamps, lamp, light->worker,
                                 light->surface->point, view);
    struct lamp_target target = lamplight_target(light, view);
    return lamps_share(light->lamps, lamp, light->worker, &target);
}

rgb lamplight_trace_fine(struct lamplight *light, const struct lamp *lamp,
                         const struct lamp_view *view)
{
    struct lamp_target target = lamplight_target(light, view);
    return lamps_share_fine(light->lamps, lamp, light->worker, &target);
}

static void lamplight_visit(const struct lamplight *light,
                            const struct lamp *lamp,
                            const struct lamp_view *view, rgb share)
{
    rgb whole = rgb_scale(lamp->light->colour, view->attenuation);
    struct light_sample sample = {
        .direction = view->direction,
        .colour = rgb_mul(whole, share),
        .highlights = !lamp->light->shadowless,
    };
    light->visit(light->context, &sample);
}

/* area_illumination: the plain mean over the grid, unshadowed, times the
 * weighted mean of the shadows (POV-Ray's formula, measured). */
static void lamplight_give_area(struct lamplight *light,
                                const struct lamp *lamp,
                                const struct lamp_view *centre)
{
    const struct light *source = lamp->light;
    vec3 point = light->surface->point;
    struct area_grid grid = area_grid_new(lamp, point, light->lamps->seed);
    struct lamp_view view;
    rgb share = light->share(light, lamp, centre);
    if (rgb_peak(share) == 0)
        return;
    share = rgb_scale(share, 1.0 / ((double)source->size1 * source->size2));
    for (int i = 0; i < source->size1; i++)
        for (int j = 0; j < source->size2 && !worker_stopped(light->worker);
             j++)
            if (lamp_look(lamp, area_grid_point(&grid, i, j), point, &view))
                lamplight_visit(light, lamp, &view, share);
}

bool lamplight_is_behind(const struct lamplight *light, const struct lamp *lamp)
{
    const struct surface *surface = light->surface;
    vec3 way = lamp_is_parallel(lamp)
                   ? vec3_negate(lamp->axis)
                   : vec3_sub(lamp->light->location, surface->point);
    return !surface_faces(surface, way);
}

void lamplight_give(struct lamplight *light, const struct lamp *lamp)
{
    const struct surface *surface = light->surface;
    vec3 location = lamp->light->location;
    struct lamp_view view;
    if (!lamp_is_for(lamp, surface->at->leaf))
        return;
    if (lamp->light->area_illumination && lamps_soft(light->lamps, lamp)) {
        lamp_look(lamp, location, surface->point, &view);
        lamplight_give_area(light, lamp, &view);
        return;
    }
    if (lamplight_is_behind(light, lamp) ||
        !lamp_look(lamp, location, surface->point, &view))
        return;
    rgb share = light->share(light, lamp, &view);
    if (rgb_peak(share) > 0)
        lamplight_visit(light, lamp, &view, share);
}
