/* POV-Ray's own illumination: one shadow ray for each lamp (a grid of them for
 * area lights) and a constant ambient light. What the other methods are
 * compared with. */
#include "base/memory.h"
#include "lighting/lamplight.h"

static void *rays_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    struct lamps *lamps = memory_new(sizeof *lamps);
    if (scene->settings.radiosity)
        diag_print(diag, DIAG_WARNING, span_none(), NULL,
                   "--lighting rays ignores the scene's radiosity: to follow "
                   "light on from surface to surface type --lighting mesh");
    *lamps = lamps_new(world, scene, options->quality, options->seed);
    return lamps;
}

static void rays_finish(void *state)
{
    if (!state)
        return;
    lamps_free(state);
    memory_free(state);
}

static struct diffuse_light rays_illuminate(const void *state,
                                            struct worker *worker,
                                            const struct surface *surface,
                                            light_visit *visit, void *context)
{
    const struct lamps *lamps = state;
    struct lamplight light = {
        .lamps = lamps,
        .worker = worker,
        .surface = surface,
        .visit = visit,
        .context = context,
        .share = lamplight_trace,
    };
    for (size_t i = 0; i < lamps->count; i++)
        lamplight_give(&light, &lamps->items[i]);
    return (struct diffuse_light){ .ambient =
                                       lamps->scene->settings.ambient_light };
}

static const struct lamps *rays_lamps(const void *state)
{
    return state;
}

const struct lighting rays_lighting = {
    .name = "rays",
    .help = "POV-Ray's own: shadow rays to every light and an ambient term",
    .start = rays_start,
    .finish = rays_finish,
    .illuminate = rays_illuminate,
    .lamps = rays_lamps,
};
