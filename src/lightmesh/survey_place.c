/* Places that a picture shows: see survey_place.h. */
#include "lightmesh/survey_place.h"

#include "lightmesh/gather_paint.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* Turns the ray to where it goes on from a surface that shows more of others
 * than of itself: through it, or as it mirrors. What shows nothing of itself
 * may show little of others, too. Returns false if it ends there. */
static bool place_goes_on(const struct surface *surface, struct ray *ray)
{
    double own = rgb_brightness(surface_albedo(surface));
    double least = own > 0 ? pane_least : gather_least;
    ray->origin = surface->point;
    if (rgb_brightness(surface->through) >= least)
        return true;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        if (rgb_brightness(rgb_mul(layer->weight, layer->reflection)) < least)
            continue;
        ray->direction =
            surface_mirrored(surface->normal, ray->direction, layer->normal);
        return true;
    }
    return false;
}

bool survey_place_find(struct survey_place *place, const struct gather *gather,
                       const struct camera *camera, double x, double y)
{
    const struct world *world = gather->lamps->world;
    struct survey_place pane; /* the last that shows something of itself */
    bool found = false;
    if (!camera_sees(camera, x, y))
        return false;
    struct ray ray = camera_ray(camera, x, y);
    for (int i = 0; i < SURVEY_PANES; i++) {
        if (!world_closest(world, &ray, surface_offset(ray.origin), RAY_SIGHT,
                           &place->at))
            break;
        gather_surface(gather, &ray, &place->at, &place->surface);
        if (!place_goes_on(&place->surface, &ray))
            return true;
        if (rgb_brightness(surface_albedo(&place->surface)) >= pane_shows) {
            pane = *place;
            found = true;
        }
    }
    if (found) {
        *place = pane;
        place->surface.at = &place->at;
    }
    return found;
}
