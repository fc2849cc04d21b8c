/* Meshes of a size that has room: see mesh_state.h. */
#include "lighting/mesh_state.h"

#include "lighting/mesh_close.h"
#include "lighting/mesh_survey.h"
#include "lightmesh/census.h"
#include "lightmesh/indirect.h"
#include "lightmesh/plan_rays.h"
#include "lightmesh/tuning.h"

void mesh_clear(struct mesh_lighting *mesh)
{
    indirect_mesh_free(mesh->indirect);
    direct_mesh_free(mesh->direct);
    mesh->indirect = NULL;
    mesh->direct = NULL;
}

void mesh_make(struct mesh_lighting *mesh, const struct scene *scene,
               const struct interpolation *interpolation)
{
    const struct skeleton *skeleton = mesh->close.skeleton;
    struct plan *plan = &mesh->plan;
    mesh_clear(mesh);
    *plan = plan_new(scene, &mesh->lamps, &mesh->stamp.frame, interpolation,
                     skeleton ? mesh_close_light : NULL, skeleton);
    plan->indirect.bright = &mesh->stamp.frame.bright;
    plan->indirect.virtual_lights = mesh->virtual_lights;
    plan->indirect.picks = mesh->stamp.frame.picks;
    plan->indirect.glow_picks = mesh->stamp.frame.glow_picks;
    mesh->direct_view = plan->direct.view;
    mesh->indirect_view = plan->indirect.view;
    mesh->direct_view.eye = mesh->indirect_view.eye = scene->camera.location;
    mesh->direct_view.finest = mesh->levels.direct;
    mesh->indirect_view.finest = mesh->levels.indirect;
    mesh->direct = direct_mesh_new(&mesh->lamps, &plan->direct);
    if (plan->indirect.bounces == 0)
        return;
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const bool film = mesh->film != PLAN_ALONE;
    const struct plan_own own =
        plan_own_rays(said, &mesh->survey, &plan->indirect.lattice,
                      &plan->indirect.view, film);
    plan->indirect.near_lone = plan_lone_rays(said, &mesh->survey, film);
    plan->indirect.near_own = own.rays;
    plan->indirect.own_worth = own.worth;
    mesh->indirect = indirect_mesh_new(mesh->direct, mesh->emitters,
                                       &mesh->ambience, &plan->indirect);
}

/* What is to be counted before points are made. */
static struct census mesh_census(const struct mesh_lighting *mesh,
                                 const struct scene *scene,
                                 const struct lighting_options *options)
{
    return (struct census){
        .scene = scene,
        .direct = mesh->direct,
        .space = mesh->plan.lamps != PLAN_EACH,
        .surfaces = mesh->plan.direct.surfaces,
        .indirect = mesh->indirect,
        .direct_view = mesh->direct_view,
        .indirect_view = mesh->indirect_view,
        .pixels = options->width > 0 ? (double)options->width * options->height
                                     : usual_width * usual_height,
        .stop = options->stop,
    };
}

/* An indirect mesh of no more gather rays than the picture is worth. */
static void mesh_afford(struct mesh_lighting *mesh, const struct scene *scene,
                        const struct interpolation *interpolation,
                        const struct lighting_options *options)
{
    if (!mesh->indirect || options->numbers)
        return;
    const struct census census = mesh_census(mesh, scene, options);
    if (plan_afford(&mesh->stamp.frame, scene, &mesh->survey,
                    census_gathered(&census), census.pixels,
                    mesh->film != PLAN_ALONE))
        mesh_make(mesh, scene, interpolation);
}

/* Whether there will be more points than have room. */
static bool mesh_crowded(const struct mesh_lighting *mesh,
                         const struct scene *scene,
                         const struct lighting_options *options)
{
    const struct census census = mesh_census(mesh, scene, options);
    return census_crowding(&census) > 1;
}

static bool mesh_fit_stopped(const struct lighting_options *options)
{
    return options->stop && atomic_load(options->stop);
}

bool mesh_fit(struct mesh_lighting *mesh, const struct scene *scene,
              const struct interpolation *interpolation,
              const struct outlook *outlook,
              const struct lighting_options *options, struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    int coarser = 0;
    mesh_make(mesh, scene, interpolation);
    mesh_afford(mesh, scene, interpolation, options);
    if (mesh->rooted &&
        plan_follow(&mesh->stamp.frame, &mesh->root, &mesh->levels))
        mesh_make(mesh, scene, interpolation);
    while (coarser < SPACINGS_MOST && mesh_crowded(mesh, scene, options) &&
           !mesh_fit_stopped(options)) {
        mesh->levels = (struct plan_levels){ 0, 0 };
        mesh->stamp.frame =
            plan_frame(scene, outlook, &mesh->survey, mesh->film, ++coarser);
        mesh_make(mesh, scene, interpolation);
        mesh_afford(mesh, scene, interpolation, options);
    }
    if (mesh_fit_stopped(options))
        return false;
    if (!(said->density > 0) || coarser == 0)
        return true;
    double density = 1 / mesh->stamp.frame.spacing;
    double step = pow(10, floor(log10(density)) - 1);
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "a light mesh of density %.3g needs more than the %.0f MB that "
               "glim gives it: type --mesh-density %g, or less",
               said->density, (double)MESH_BYTES * 1e-6,
               floor(density / step) * step);
    return false;
}
