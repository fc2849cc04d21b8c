/* POV-Ray's own illumination: one shadow ray for each lamp (a grid of them for
 * area lights) and a constant ambient light. What the other methods are
 * compared with.
 *
 * Where the scene has radiosity {} the light of surfaces is that of the light
 * mesh, as POV-Ray's would be if it took no shortcuts (measured):
 * recursion_limit bounces and darkness after them, of which each is multiplied
 * by `brightness` and loses colour by `gray_threshold`; without bumps, unless
 * `normal on` says so. Since version 3.7 it takes the place of all ambient
 * light; before, `ambient` is light that a surface sends to others as well. */
#include "base/memory.h"
#include "lighting/lamplights.h"
#include "lighting/mesh_bounced.h"
#include "lightmesh/indirect.h"

struct rays_lighting {
    struct lamps lamps;
    struct scene scene; /* of the mesh: a copy with settings of its own */
    void *mesh;         /* of radiosity; NULL: there is none */
};

static bool rays_bounce(const struct scene *scene, int quality)
{
    const struct settings *settings = &scene->settings;
    return settings->radiosity && settings->light_mesh.indirect.on &&
           quality >= QUALITY_FOG;
}

/* How the mesh is told to do what radiosity does. */
static void rays_ask_mesh(struct settings *settings)
{
    const struct radiosity_settings *said = &settings->radiosity_said;
    struct light_mesh_settings *mesh = &settings->light_mesh;
    mesh->indirect.bounces = said->recursion_limit < BOUNCES_MAX
                                 ? said->recursion_limit
                                 : BOUNCES_MAX;
    mesh->indirect.tone = said->tone;
    mesh->indirect.skeleton = false;
    mesh->indirect.dark = true;
}

static void rays_finish(void *state)
{
    struct rays_lighting *rays = state;
    if (!rays)
        return;
    mesh_lighting.finish(rays->mesh);
    lamps_free(&rays->lamps);
    memory_free(rays);
}

static void *rays_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    struct rays_lighting *rays = memory_new(sizeof *rays);
    rays->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (!rays_bounce(scene, options->quality))
        return rays;
    rays->scene = *scene;
    rays_ask_mesh(&rays->scene.settings);
    rays->mesh = mesh_lighting.start(world, &rays->scene, options, diag);
    if (rays->mesh)
        return rays;
    rays_finish(rays);
    return NULL;
}

/* None is left beside radiosity, unless the scene is old. */
static rgb rays_ambient(const struct rays_lighting *rays)
{
    const struct settings *settings = &rays->lamps.scene->settings;
    return rays->mesh && !settings_keep_ambient(settings)
               ? rgb_grey(0)
               : settings->ambient_light;
}

/* By light of surfaces. */
static rgb rays_irradiance(const struct rays_lighting *rays,
                           struct worker *worker, const struct surface *surface)
{
    return rays->mesh ? mesh_bounced(
                            rays->mesh, worker, surface,
                            !rays->lamps.scene->settings.radiosity_said.normal)
                      : rgb_grey(0);
}

static struct diffuse_light rays_illuminate(const void *state,
                                            struct worker *worker,
                                            const struct surface *surface,
                                            light_visit *visit, void *context)
{
    const struct rays_lighting *rays = state;
    const struct lamps *lamps = &rays->lamps;
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
    return (struct diffuse_light){ rays_ambient(rays),
                                   rays_irradiance(rays, worker, surface) };
}

static void rays_illuminate_many(const void *state, struct worker *worker,
                                 struct facets *facets,
                                 struct facets_diffuse *diffuse)
{
    const struct rays_lighting *rays = state;
    const struct lamps *lamps = &rays->lamps;
    struct lamplights lights;
    lights.lamps = lamps;
    lights.worker = worker;
    lights.share = lamplight_trace;
    lights.traced = lamps_share;
    lights.foresee = NULL;
    lamplights_start(&lights, facets);
    for (size_t i = 0; i < lamps->count; i++)
        lamplights_give(&lights, &lamps->items[i]);
    diffuse->even = true;
    diffuse->of[0] = (struct diffuse_light){ rays_ambient(rays), rgb_grey(0) };
}

/* Light of surfaces is shared by the rays of a pixel, as they come. */
static bool rays_in_any_order(const void *state)
{
    const struct rays_lighting *rays = state;
    return !rays->mesh;
}

static const struct lamps *rays_lamps(const void *state)
{
    const struct rays_lighting *rays = state;
    return &rays->lamps;
}

static bool rays_foresees(void *state, struct first_hits *grid)
{
    struct rays_lighting *rays = state;
    return rays->mesh && mesh_lighting.foresees(rays->mesh, grid);
}

static void rays_prepare(void *state, const struct first_hits *hits,
                         struct worker *const *workers, unsigned threads)
{
    struct rays_lighting *rays = state;
    mesh_lighting.prepare(rays->mesh, hits, workers, threads);
}

const struct lighting rays_lighting = {
    .name = "rays",
    .help = "POV-Ray's own: shadow rays to every light and an ambient term",
    .start = rays_start,
    .finish = rays_finish,
    .foresees = rays_foresees,
    .prepare = rays_prepare,
    .illuminate = rays_illuminate,
    .illuminate_many = rays_illuminate_many,
    .in_any_order = rays_in_any_order,
    .lamps = rays_lamps,
};
