/* Photons as light at a surface: see photons.h. */
#include "tracer/photons.h"

#include "scene/photon.h"
#include "shade/finish.h"
#include "shade/lamp.h"

/* Light that comes in flatter than this counts as if it came so. */
static const double cosine_least = 0.05;

struct lighting_up {
    const struct tracer *tracer;
    const struct surface *surface;
    light_visit *visit;
    void *context;
    rgb sum;   /* of irradiances */
    vec3 from; /* weighted with them */
};

/* Whether the lamp it came from lights the surface at all. */
static bool photon_counts(const struct lighting_up *up,
                          const struct photon *photon)
{
    size_t count;
    const struct light *lights = world_lights(up->tracer->world, &count);
    return light_is_for(&lights[photon->lamp], up->surface->at->leaf);
}

/* Irradiance from a direction is light times its cosine. */
static void light_up(const struct lighting_up *up, vec3 from, rgb irradiance)
{
    double cosine = fmax(vec3_dot(from, up->surface->normal), cosine_least);
    struct light_sample sample = { .direction = from,
                                   .colour = rgb_scale(irradiance, 1 / cosine),
                                   .highlights = true };
    up->visit(up->context, &sample);
}

static void visit_each(void *context, const struct photon *photon,
                       rgb irradiance)
{
    const struct lighting_up *up = context;
    if (photon_counts(up, photon))
        light_up(up, photon_unpack(photon->from), irradiance);
}

static void visit_sum(void *context, const struct photon *photon,
                      rgb irradiance)
{
    struct lighting_up *up = context;
    if (!photon_counts(up, photon))
        return;
    up->sum = rgb_add(up->sum, irradiance);
    up->from =
        vec3_along(up->from, photon_unpack(photon->from), rgb_peak(irradiance));
}

/* Whether more than the sum of them matters: highlights, or cosines that are
 * not their own. */
static bool surface_tells_apart(const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++) {
        const struct finish *finish = surface->layer[i].finish;
        if (finish->brilliance != 1 || finish_shines(finish))
            return true;
    }
    return false;
}

void photons_light(const struct tracer *tracer, struct worker *worker,
                   const struct surface *surface, light_visit *visit,
                   void *context)
{
    struct lighting_up up = { tracer,  surface,     visit,
                              context, rgb_grey(0), { 0, 0, 0 } };
    if (!tracer->photons || surface->at->leaf->look->photons->unlit)
        return;
    bool each = surface_tells_apart(surface);
    photon_map_visit(tracer->photons, worker, surface->point, surface->normal,
                     each ? visit_each : visit_sum, &up);
    if (!each && rgb_peak(up.sum) > 0)
        light_up(&up, vec3_normalise(up.from), up.sum);
}
