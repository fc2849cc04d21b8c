/* Light meshes (Debelov and Sevastyanov 2002): lamps are asked from mesh
 * points, which surfaces then share. `ambient` stands for what comes in from
 * outside (shade/ambience.h). */
#include "base/memory.h"
#include "lighting/ambient.h"
#include "lighting/lamplight.h"
#include "lighting/mesh_close.h"
#include "lighting/mesh_diffuse.h"
#include "lighting/mesh_known.h"
#include "lighting/mesh_pixels.h"
#include "lighting/mesh_report.h"
#include "lighting/mesh_scalar.h"
#include "lighting/mesh_views.h"
#include "lighting/names.h"
#include "lightmesh/census.h"
#include "lightmesh/facet_mesh.h"
#include "lightmesh/indirect.h"
#include "lightmesh/outlook.h"
#include "lightmesh/plan.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"

struct mesh_lighting {
    struct lamps lamps;
    struct ambience ambience;
    struct direct_mesh *direct;
    struct plan plan;
    struct emitters *emitters;      /* with indirect light */
    struct indirect_mesh *indirect; /* or NULL */
    struct scalar_mesh *scalar;     /* of model scalar, in place of them all */
    struct void_skeleton close;     /* what ends its bounces, if asked for */
    struct mesh_pixels pixels;      /* that lamps look at */
    struct knowers knowers;
    struct mesh_report report;
    /* How this picture's camera asks; what mesh points hold must not depend on
     * it, only on the stamp's frame. */
    struct lattice_view direct_view, indirect_view;
    struct mesh_stamp stamp;
};

/* The paper's meshes. */
static struct scalar_mesh *mesh_literal(const struct lamps *lamps,
                                        const struct light_mesh_settings *said,
                                        struct direct_options *options)
{
    int samples =
        said->indirect.samples ? said->indirect.samples : SCALAR_SAMPLES;
    options->bytes = MESH_BYTES;
    return scalar_mesh_new(lamps, options, said->indirect.on ? samples : 0);
}

enum { MESHES_MAX = 2 + BOUNCES_MAX };

/* All that hold points, in the order in which files hold them. */
static size_t mesh_points(const struct mesh_lighting *mesh,
                          const struct point_mesh *meshes[MESHES_MAX])
{
    size_t count = 0;
    if (mesh->scalar) {
        meshes[count++] = &mesh->scalar->direct;
        if (mesh->scalar->samples > 0)
            meshes[count++] = &mesh->scalar->indirect;
        return count;
    }
    meshes[count++] = &mesh->direct->points;
    if (mesh->direct->facets)
        meshes[count++] = &mesh->direct->facets->points;
    for (struct indirect_mesh *i = mesh->indirect; i; i = i->next)
        meshes[count++] = &i->points;
    return count;
}

static void mesh_clear(struct mesh_lighting *mesh)
{
    scalar_mesh_free(mesh->scalar);
    indirect_mesh_free(mesh->indirect);
    direct_mesh_free(mesh->direct);
    mesh->scalar = NULL;
    mesh->indirect = NULL;
    mesh->direct = NULL;
}

static void mesh_finish(void *state)
{
    struct mesh_lighting *mesh = state;
    if (!mesh)
        return;
    mesh_pixels_free(&mesh->pixels);
    mesh_clear(mesh);
    void_skeleton_free(&mesh->close);
    emitters_free(mesh->emitters);
    lamps_free(&mesh->lamps);
    memory_free(mesh);
}

/* The meshes of the stamp's frame, without points. */
static void mesh_make(struct mesh_lighting *mesh, const struct scene *scene,
                      const struct interpolation *interpolation)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct skeleton *skeleton = mesh->close.skeleton;
    struct plan *plan = &mesh->plan;
    mesh_clear(mesh);
    *plan = plan_new(scene, &mesh->lamps, &mesh->stamp.frame, interpolation,
                     skeleton ? mesh_close_light : NULL, skeleton);
    mesh->direct_view = plan->direct.view;
    mesh->indirect_view = plan->indirect.view;
    mesh->direct_view.eye = mesh->indirect_view.eye = scene->camera.location;
    if (said->model == MESH_MODEL_SCALAR) {
        mesh->scalar = mesh_literal(&mesh->lamps, said, &plan->direct);
        return;
    }
    mesh->direct = direct_mesh_new(&mesh->lamps, &plan->direct);
    if (plan->indirect.bounces > 0)
        mesh->indirect = indirect_mesh_new(mesh->direct, mesh->emitters,
                                           &mesh->ambience, &plan->indirect);
}

/* How many times too many points there will be. */
static double mesh_crowding(const struct mesh_lighting *mesh,
                            const struct scene *scene,
                            const struct lighting_options *options)
{
    struct census census = {
        .scene = scene,
        .direct = mesh->direct,
        .space = mesh->plan.lamps != PLAN_EACH,
        .surfaces = mesh->plan.direct.surfaces,
        .indirect = mesh->indirect,
        .direct_view = mesh->direct_view,
        .indirect_view = mesh->indirect_view,
        .pixels = (double)options->width * options->height,
    };
    return mesh->scalar ? 0 : census_crowding(&census);
}

/* Meshes whose points have room, as near to each other as the scene and the
 * picture want, or less. Returns false after an error was printed: as near as
 * was said they have none. */
static bool mesh_fit(struct mesh_lighting *mesh, const struct scene *scene,
                     const struct interpolation *interpolation,
                     const struct outlook *outlook,
                     const struct lighting_options *options, struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    int coarser = 0;
    mesh_make(mesh, scene, interpolation);
    while (coarser < SPACINGS_MOST && mesh_crowding(mesh, scene, options) > 1) {
        mesh->stamp.frame =
            plan_frame(mesh->lamps.world, scene, outlook, ++coarser);
        mesh_make(mesh, scene, interpolation);
    }
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

static void mesh_report_on(struct mesh_lighting *mesh)
{
    const struct direct_options *direct = &mesh->plan.direct;
    const struct lattice *lattice = &direct->lattice;
    mesh->report = (struct mesh_report){
        .direct = mesh->direct,
        .indirect = mesh->indirect,
        .scalar = mesh->scalar,
        .spacing = lattice_spacing(lattice, lattice->usual),
        .size = direct->size,
        .direct_view = direct->view,
        .indirect_view = mesh->plan.indirect.view,
    };
}

/* What is known already, and meshes for the rest. */
static bool mesh_begin(struct mesh_lighting *mesh, const struct scene *scene,
                       const struct outlook *outlook,
                       const struct lighting_options *options,
                       struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct point_mesh *meshes[MESHES_MAX];
    const struct interpolation *interpolation =
        names_interpolation(&scene->settings, diag);
    struct mesh_known known;
    bool done =
        mesh_known_find(&known, &mesh->stamp, options, said->load_file, diag);
    done =
        done && interpolation &&
        mesh_close_make(&mesh->close, mesh->lamps.world, scene, options, diag);
    if (done && known.found) {
        mesh->stamp = known.file.stamp;
        mesh_make(mesh, scene, interpolation);
        done = mesh_known_fill(&known, meshes, mesh_points(mesh, meshes), diag);
    } else if (done) {
        done = mesh_fit(mesh, scene, interpolation, outlook, options, diag);
    }
    mesh_known_end(&known);
    return done;
}

static void *mesh_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    struct mesh_lighting *mesh = memory_new(sizeof *mesh);
    struct outlook outlook = outlook_of(world, scene, options->width);
    mesh->ambience = ambience_new(world, scene);
    if (mesh->ambience.sky)
        ambient_dropped(scene, diag);
    mesh->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (said->indirect.on)
        mesh->emitters = emitters_new(world);
    if (options->keep || said->load_file)
        mesh->stamp =
            mesh_stamp_new(scene, plan_held(said, mesh->lamps.count),
                           said->indirect.on, options->quality, options->seed);
    mesh->stamp.frame = plan_frame(world, scene, &outlook, 0);
    if (!mesh_begin(mesh, scene, &outlook, options, diag)) {
        mesh_finish(mesh);
        return NULL;
    }
    mesh->pixels =
        mesh_pixels_new(&mesh->lamps, scene, &mesh->plan, outlook.pixel);
    mesh->knowers = (struct knowers){ .plan = &mesh->plan,
                                      .lamps = &mesh->lamps,
                                      .direct = mesh->direct };
    mesh_report_on(mesh);
    return mesh;
}

static struct lighting_kept mesh_keep(const void *state)
{
    const struct mesh_lighting *mesh = state;
    const struct point_mesh *meshes[MESHES_MAX];
    size_t count = mesh_points(mesh, meshes);
    struct lighting_kept kept;
    kept.bytes = mesh_file_pack(&mesh->stamp, meshes, count, &kept.size);
    return kept;
}

static bool mesh_shines(const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++) {
        const struct finish *finish = surface->layer[i].finish;
        if (finish->phong != 0 || finish->specular != 0)
            return true;
    }
    return false;
}

/* Highlights of many lamps are those of one, where most of the light is. */
static void mesh_shine(const struct lamplight *asked, vec3 direction, rgb light)
{
    struct light_sample sample = { .direction = direction,
                                   .colour = light,
                                   .highlights = true,
                                   .diffused = true };
    if (rgb_peak(light) > 0)
        asked->visit(asked->context, &sample);
}

/* A side of a surface that asks for light. */
static struct receiver mesh_receiver(const struct surface *surface, vec3 side,
                                     vec3 normal, struct lattice_view view)
{
    bool first = surface->place && vec3_dot(side, surface->side) > 0;
    return (struct receiver){
        .point = surface->point,
        .side = side,
        .normal = normal,
        .from = vec3_along(surface->point, surface->view, surface->at->t),
        .at = surface->at,
        .pixel = first ? surface->place : NULL,
        .view = view,
        .weight = 1,
    };
}

/* What the lamps in front of the surface, or behind it, give its first layer,
 * to be multiplied by its diffuse share. */
static rgb mesh_side(const struct mesh_lighting *mesh,
                     const struct lamplight *asked, double sign)
{
    const struct surface *surface = asked->surface;
    const struct surface_layer *layer = &surface->layer[0];
    double brilliance = layer->finish->brilliance;
    const struct receiver receiver =
        mesh_receiver(surface, vec3_scale(surface->side, sign),
                      vec3_scale(layer->normal, sign), mesh->direct_view);
    struct asking asking;
    struct incident incident;
    asking_start(&asking, &mesh->knowers, asked->worker, &receiver,
                 surface->inside);
    asking_all_lamps(&asking, &incident);
    rgb light = incident_irradiance(&incident, &receiver, brilliance);
    if (sign > 0 && mesh_shines(surface)) {
        rgb from_there;
        vec3 direction = incident_direction(&incident, &from_there);
        mesh_shine(asked, direction, from_there);
    }
    double albedo = layer->finish->diffuse_albedo ? (brilliance + 1) / 2 : 1;
    return rgb_scale(light, albedo);
}

static rgb mesh_many(const struct mesh_lighting *mesh,
                     const struct lamplight *asked)
{
    const struct surface *surface = asked->surface;
    const struct finish *finish = surface->layer[0].finish;
    double back = surface->at->leaf->double_illuminate ? finish->diffuse
                                                       : finish->diffuse_back;
    rgb light = mesh_side(mesh, asked, 1);
    if (back != 0 && finish->diffuse != 0)
        light = rgb_add_scaled(light, mesh_side(mesh, asked, -1),
                               back / finish->diffuse);
    return light;
}

/* A surface whose lamps are asked one by one. */
struct mesh_asker {
    struct lamplight light; /* first: its address is ours */
    struct asking asking;
};

static rgb mesh_asker_share(struct lamplight *light, const struct lamp *lamp,
                            const struct lamp_view *view)
{
    struct mesh_asker *asker = (struct mesh_asker *)light;
    return asking_one_lamp(&asker->asking, lamp, view);
}

/* Whether what comes from behind counts too. */
static bool mesh_both_sides(const struct surface *surface)
{
    if (surface->at->leaf->double_illuminate)
        return true;
    for (int i = 0; i < surface->count; i++)
        if (surface->layer[i].finish->diffuse_back != 0)
            return true;
    return false;
}

/* Visits the lamps' samples. */
static void mesh_few(const struct mesh_lighting *mesh,
                     const struct lamplight *light)
{
    const struct surface *surface = light->surface;
    const struct receiver receiver =
        mesh_receiver(surface, surface->side, surface->side, mesh->direct_view);
    bool both = mesh_both_sides(surface);
    struct mesh_asker asker;
    asker.light = *light;
    asker.light.share = mesh_asker_share;
    asking_start(&asker.asking, &mesh->knowers, light->worker, &receiver,
                 surface->inside);
    for (size_t i = 0; i < light->lamps->count; i++) {
        const struct lamp *lamp = &light->lamps->items[i];
        if (both || !asking_rules_out(&asker.asking, lamp))
            lamplight_give(&asker.light, lamp);
    }
}

/* Mesh points are of all surfaces: where groups have lamps of their own, each
 * surface asks for itself. */
static void mesh_groups_give(struct lamplight *light)
{
    light->share = lamplight_trace_fine;
    for (size_t i = 0; i < light->lamps->count; i++)
        lamplight_give(light, &light->lamps->items[i]);
}

static struct diffuse_light mesh_illuminate(const void *state,
                                            struct worker *worker,
                                            const struct surface *surface,
                                            light_visit *visit, void *context)
{
    const struct mesh_lighting *mesh = state;
    struct diffuse_light diffuse = { mesh->ambience.light, rgb_grey(0) };
    if (surface->count == 0)
        return diffuse;
    struct lamplight light = {
        .lamps = &mesh->lamps,
        .worker = worker,
        .surface = surface,
        .visit = visit,
        .context = context,
    };
    if (mesh->scalar)
        return mesh_scalar_light(mesh->scalar, &light);
    if (mesh->lamps.scene->light_groups)
        mesh_groups_give(&light);
    else if (mesh->direct->many)
        diffuse.irradiance = mesh_many(mesh, &light);
    else
        mesh_few(mesh, &light);
    if (mesh->indirect) {
        struct diffuse_light more =
            mesh_diffuse(mesh->indirect, mesh->indirect_view, &mesh->ambience,
                         worker, surface);
        diffuse.ambient = more.ambient;
        diffuse.irradiance = rgb_add(diffuse.irradiance, more.irradiance);
    }
    return diffuse;
}

static const struct lamps *mesh_lamps(const void *state)
{
    const struct mesh_lighting *mesh = state;
    return &mesh->lamps;
}

static bool mesh_foresees(void *state, const struct first_hits *grid)
{
    struct mesh_lighting *mesh = state;
    return mesh_pixels_wanted(&mesh->pixels, grid);
}

static void mesh_look_ahead(void *state, const struct first_hits *hits,
                            struct worker *const *workers, unsigned threads)
{
    struct mesh_lighting *mesh = state;
    mesh_pixels_make(&mesh->pixels, hits, workers, threads);
    mesh->report.pixels = mesh->knowers.pixels = mesh->pixels.mesh;
    mesh->report.penumbras = mesh->knowers.penumbras = mesh->pixels.penumbras;
}

static void mesh_tell(const void *state, lighting_row *row, void *context)
{
    const struct mesh_lighting *mesh = state;
    if (!mesh->scalar)
        plan_tell(&mesh->plan, row, context);
    mesh_report_tell(&mesh->report, row, context);
}

/* Where no mesh point was asked for a lamp there may be those of surfaces. */
static void mesh_give_direct(const void *state, struct show *show)
{
    const struct mesh_lighting *mesh = state;
    if (mesh->scalar)
        mesh_show_scalar(&mesh->scalar->direct, show);
    else
        mesh_show_direct(mesh->direct, mesh->pixels.mesh, show);
    if (!mesh->scalar && show->points.count == 0)
        mesh_show_indirect(mesh->indirect, show);
}

static void mesh_give_indirect(const void *state, struct show *show)
{
    const struct mesh_lighting *mesh = state;
    if (mesh->scalar && mesh->scalar->samples > 0)
        mesh_show_scalar(&mesh->scalar->indirect, show);
    else
        mesh_show_indirect(mesh->indirect, show);
}

static const struct lighting_view mesh_views[] = {
    { "mesh", "mesh points, by the light of lamps, or else of surfaces",
      mesh_give_direct, "--mesh-shadows soft" },
    { "mesh:indirect", "by the light of surfaces", mesh_give_indirect,
      "--mesh-indirect on" },
    { NULL, NULL, NULL },
};

const struct lighting mesh_lighting = {
    .name = "mesh",
    .help = "light meshes: light from surface to surface, and of many lamps",
    .start = mesh_start,
    .finish = mesh_finish,
    .foresees = mesh_foresees,
    .prepare = mesh_look_ahead,
    .illuminate = mesh_illuminate,
    .lamps = mesh_lamps,
    .tell = mesh_tell,
    .keep = mesh_keep,
    .views = mesh_views,
};
