/* Light meshes (Debelov and Sevastyanov 2002): lamps are asked from mesh
 * points, which surfaces then share. `ambient` stands for what comes in from
 * outside (shade/ambience.h). */
#include "base/memory.h"
#include "lighting/ambient.h"
#include "lighting/knower_view.h"
#include "lighting/mesh_bounced.h"
#include "lighting/mesh_close.h"
#include "lighting/mesh_diffuse.h"
#include "lighting/mesh_known.h"
#include "lighting/mesh_lamps.h"
#include "lighting/mesh_moments.h"
#include "lighting/mesh_survey.h"
#include "lighting/mesh_views.h"
#include "lighting/names.h"
#include "lightmesh/facet_mesh.h"
#include "lightmesh/indirect.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"

enum { MESHES_MAX = 2 + BOUNCES_MAX };

/* All that hold points, in the order in which files hold them. */
static size_t mesh_points(const struct mesh_lighting *mesh,
                          const struct point_mesh *meshes[MESHES_MAX])
{
    size_t count = 0;
    meshes[count++] = &mesh->direct->points;
    if (mesh->direct->facets)
        meshes[count++] = &mesh->direct->facets->points;
    for (struct indirect_mesh *i = mesh->indirect; i; i = i->next)
        meshes[count++] = &i->points;
    return count;
}

static void mesh_finish(void *state)
{
    struct mesh_lighting *mesh = state;
    if (!mesh)
        return;
    mesh_pixels_free(&mesh->pixels);
    indirect_pixels_free(mesh->indirect_pixels);
    mesh_clear(mesh);
    if (!mesh->now) {
        void_skeleton_free(&mesh->close);
        virtual_lights_free(mesh->virtual_lights);
    }
    emitters_free(mesh->emitters);
    lamps_free(&mesh->lamps);
    memory_free(mesh);
}

static void mesh_report_on(struct mesh_lighting *mesh)
{
    const struct direct_options *direct = &mesh->plan.direct;
    const struct lattice *lattice = &direct->lattice;
    struct mesh_report *report = &mesh->report;
    const struct lattice_view *view = &mesh->plan.indirect.view;
    int bounce = 0;
    report->spacing = lattice_spacing(lattice, lattice->usual);
    report->size = direct->size;
    mesh_report_add(report, "direct", &mesh->direct->points, &direct->view);
    if (mesh->direct->facets)
        mesh_report_add(report, "surface", &mesh->direct->facets->points, view);
    for (struct indirect_mesh *i = mesh->indirect; i; i = i->next) {
        char name[24];
        snprintf(name, sizeof name, "bounce %d", ++bounce);
        mesh_report_add(report, name, &i->points, view);
    }
}

/* What is half open is planned as what is open. */
static void mesh_open(struct mesh_lighting *mesh, const struct scene *scene,
                      const struct outlook *outlook)
{
    struct survey *survey = &mesh->survey;
    survey->closed = false;
    survey->lit.count = survey->bright.count = 0;
    virtual_lights_free(mesh->virtual_lights);
    mesh->virtual_lights = NULL;
    void_skeleton_free(&mesh->close);
    mesh->close = (struct void_skeleton){ NULL, NULL };
    mesh->stamp.frame = plan_frame(scene, outlook, survey, mesh->film, 0);
}

/* Where the skeleton doesn't know the light a chamber gathers more, for rays
 * that go on by chance have to end the bounces. */
static void mesh_see(struct mesh_lighting *mesh, const struct scene *scene,
                     const struct outlook *outlook,
                     const struct lighting_options *options)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    struct mesh_frame *frame = &mesh->stamp.frame;
    struct worker worker = { .stop = options->stop, .scratch = arena_new(0) };
    bool knows = !frame->closed || frame->samples == 0 ||
                 said->indirect.samples > 0 ||
                 mesh_close_knows(&mesh->close, &mesh->survey, &worker);
    arena_free(worker.scratch);
    if (!knows && mesh->survey.open >= open_enough)
        mesh_open(mesh, scene, outlook);
    else if (!knows)
        frame->samples = (int)fmax(frame->samples, CHAMBER_BLIND);
}

/* Where mesh points are. */
static void mesh_frame_plan(struct mesh_lighting *mesh,
                            const struct scene *scene,
                            const struct outlook *outlook,
                            const struct lighting_options *options)
{
    mesh->film = mesh_film(options);
    mesh->rooted = mesh_known_root(&mesh->stamp, options, &mesh->root);
    const struct survey known = { .closed = mesh->root.closed,
                                  .lit = mesh->root.lit,
                                  .bright = mesh->root.bright };
    mesh_look(mesh, scene, options, mesh->rooted ? &known : NULL);
    mesh->stamp.frame =
        plan_frame(scene, outlook, &mesh->survey, mesh->film, 0);
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
    mesh_frame_plan(mesh, scene, outlook, options);
    bool done =
        mesh_known_find(&known, &mesh->stamp, options, said->load_file, diag);
    if (done && known.found) {
        mesh->stamp = known.file.stamp;
        mesh->levels = known.levels;
        mesh_virtual_again(mesh, options);
    }
    const struct mesh_frame *frame = &mesh->stamp.frame;
    done = done && interpolation &&
           (!frame->closed || frame->samples == 0 ||
            mesh_close_make(&mesh->close, mesh->lamps.world, scene, options,
                            mesh->rooted ? options->kept->pieces : NULL, diag));
    const struct skeleton *closing = mesh->close.skeleton;
    mesh->ambience.everywhere |= closing && closing->ambience.everywhere;
    if (done && !known.found)
        mesh_see(mesh, scene, outlook, options);
    if (done && known.found)
        mesh_make(mesh, scene, interpolation);
    else if (done)
        done = mesh_fit(mesh, scene, interpolation, outlook, options, diag);
    if (done && mesh_known_same(&known, &mesh->stamp, options))
        done = mesh_known_fill(&known, meshes, mesh_points(mesh, meshes), diag);
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
    mesh->width = options->width;
    mesh->height = options->height;
    mesh->ambience = ambience_new(world, scene);
    if (mesh->ambience.sky && !mesh->ambience.everywhere &&
        !said->indirect.dark)
        ambient_dropped(scene, diag);
    mesh->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (said->indirect.on)
        mesh->emitters = emitters_new(world, true);
    if (options->keep || said->load_file)
        mesh->stamp =
            mesh_stamp_new(scene, plan_held(said, mesh->lamps.count),
                           said->indirect.on, options->quality, options->seed);
    if (!mesh_by_moments(mesh, scene, options, diag) &&
        !mesh_begin(mesh, scene, &outlook, options, diag)) {
        mesh_finish(mesh);
        return NULL;
    }
    mesh->pixels =
        mesh_pixels_new(&mesh->lamps, scene, &mesh->plan, outlook.pixel);
    mesh->knowers = (struct knowers){ .plan = &mesh->plan,
                                      .lamps = &mesh->lamps,
                                      .direct = mesh->direct };
    if (mesh->indirect && options->width > 0 && !options->numbers)
        mesh->indirect_pixels =
            indirect_pixels_new(mesh->indirect, &scene->camera, options->width,
                                options->height, options->threads);
    mesh_report_on(mesh);
    return mesh;
}

static struct lighting_kept mesh_keep(const void *state)
{
    const struct mesh_lighting *mesh = state;
    const struct point_mesh *meshes[MESHES_MAX];
    size_t count = mesh_points(mesh, meshes);
    const struct skeleton *closing = mesh->close.skeleton;
    struct lighting_kept kept = {
        .family = mesh_stamp_family(&mesh->stamp),
        .inside = mesh->stamp.frame.closed,
        .pieces = closing ? skeleton_keep(closing) : NULL,
    };
    kept.bytes = mesh_file_pack(&mesh->stamp, meshes, count, &kept.size);
    return kept;
}

/* The light of surfaces, as it is asked. */
static struct mesh_indirect mesh_surfaces(const struct mesh_lighting *mesh,
                                          bool smooth)
{
    return (struct mesh_indirect){
        mesh->indirect,      mesh->indirect_pixels, &mesh->ambience,
        mesh->indirect_view, mesh->survey.worth,    smooth,
    };
}

rgb mesh_bounced(const void *state, struct worker *worker,
                 const struct surface *surface, bool smooth)
{
    const struct mesh_lighting *mesh = state;
    if (!mesh->indirect || surface->count == 0)
        return rgb_grey(0);
    const struct mesh_indirect known = mesh_surfaces(mesh, smooth);
    rgb light = mesh_diffuse(&known, worker, surface).irradiance;
    const struct settings *settings = &mesh->lamps.scene->settings;
    return bounce_toned(&settings->light_mesh.indirect.tone, light);
}

/* It comes from all around, and is for paint like that of the top layer. */
static struct diffuse_light diffuse_around(struct diffuse_light light,
                                           const struct finish *finish)
{
    light.irradiance = rgb_scale(light.irradiance, finish_around(finish));
    return light;
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
    const struct mesh_lamps lamps = { &mesh->knowers, mesh->direct_view };
    diffuse.irradiance = mesh_lamps_light(&lamps, &light);
    if (mesh->indirect) {
        const struct mesh_indirect known = mesh_surfaces(mesh, false);
        struct diffuse_light more = diffuse_around(
            mesh_diffuse(&known, worker, surface), surface->layer[0].finish);
        diffuse.ambient = more.ambient;
        diffuse.irradiance = rgb_add(diffuse.irradiance, more.irradiance);
    }
    return diffuse;
}

static bool mesh_may_mix(const void *state)
{
    const struct mesh_lighting *mesh = state;
    const struct mesh_lamps lamps = { &mesh->knowers, mesh->direct_view };
    return mesh_lamps_may_mix(&lamps);
}

static void mesh_illuminate_many(const void *state, struct worker *worker,
                                 struct facets *facets,
                                 struct facets_diffuse *diffuse)
{
    const struct mesh_lighting *mesh = state;
    const struct mesh_lamps lamps = { &mesh->knowers, mesh->direct_view };
    const struct mesh_indirect known = mesh_surfaces(mesh, false);
    mesh_lamps_light_many(&lamps, worker, facets);
    diffuse->even = false;
    for (unsigned all = facets->all; all; all &= all - 1) {
        unsigned i = (unsigned)__builtin_ctz(all);
        const struct surface *surface = facets->surface[i];
        diffuse->of[i] =
            (struct diffuse_light){ mesh->ambience.light, rgb_grey(0) };
        if (!mesh->indirect || (surface && surface->count == 0))
            continue;
        diffuse->of[i] = diffuse_around(
            surface ? mesh_diffuse(&known, worker, surface)
                    : mesh_diffuse_facet(&known, worker, facets, i),
            surface ? surface->layer[0].finish : facets->layer[0].finish[i]);
    }
}

static bool mesh_gathers(const void *state)
{
    const struct mesh_lighting *mesh = state;
    return mesh->indirect != NULL;
}

static const struct lamps *mesh_lamps(const void *state)
{
    const struct mesh_lighting *mesh = state;
    return &mesh->lamps;
}

/* What those who ask and tell are to know of the pixels. */
static void mesh_show_pixels(struct mesh_lighting *mesh)
{
    mesh->report.pixels = mesh->knowers.pixels = mesh->pixels.mesh;
    mesh->report.penumbras = mesh->knowers.penumbras = mesh->pixels.penumbras;
}

static bool mesh_foresees(void *state, struct first_hits *grid)
{
    struct mesh_lighting *mesh = state;
    bool wanted = mesh_pixels_wanted(&mesh->pixels, grid);
    mesh_show_pixels(mesh);
    return wanted;
}

static void mesh_look_ahead(void *state, const struct first_hits *hits,
                            struct worker *const *workers, unsigned threads)
{
    struct mesh_lighting *mesh = state;
    mesh_pixels_make(&mesh->pixels, hits, workers, threads);
    mesh_show_pixels(mesh);
}

static void mesh_tell(const void *state, lighting_row *row, void *context)
{
    const struct mesh_lighting *mesh = state;
    if (mesh->emitters)
        survey_tell(&mesh->survey, row, context);
    plan_tell(&mesh->plan, row, context);
    if (mesh->indirect && mesh->indirect->moments.count > 0)
        row(context, "plan frames around", mesh->indirect->moments.count - 1,
            "");
    mesh_report_tell(&mesh->report, row, context);
}

/* Where no mesh point was asked for a lamp there may be those of surfaces. */
static void mesh_give_direct(const void *state, struct show *show)
{
    const struct mesh_lighting *mesh = state;
    mesh_show_direct(mesh->direct, mesh->pixels.mesh, show);
    if (show->points.count == 0)
        mesh_show_indirect(mesh->indirect, show);
}

static void mesh_give_indirect(const void *state, struct show *show)
{
    const struct mesh_lighting *mesh = state;
    mesh_show_indirect(mesh->indirect, show);
}

static void mesh_give_knowers(const void *state, struct show *show)
{
    const struct mesh_lighting *mesh = state;
    const struct mesh_lamps lamps = { &mesh->knowers, mesh->direct_view };
    if (!scene_lamps_choose(mesh->lamps.scene))
        knower_view_give(&lamps, mesh->width, mesh->height, show);
}

static const struct lighting_view mesh_views[] = {
    { "mesh", "mesh points, by the light of lamps, or else of surfaces",
      mesh_give_direct, "--mesh-shadows soft" },
    { "mesh:indirect", "by the light of surfaces", mesh_give_indirect,
      "--mesh-indirect on" },
    { "knower", "who told the light of lamps there (src/lightmesh/README.md)",
      mesh_give_knowers, NULL },
    { NULL, NULL, NULL },
};

const struct lighting mesh_lighting = {
    .name = "mesh",
    .help = "light meshes: light from surface to surface, and of many lamps",
    .start = mesh_start,
    .finish = mesh_finish,
    .by_moments = mesh_gathers,
    .foresees = mesh_foresees,
    .prepare = mesh_look_ahead,
    .illuminate = mesh_illuminate,
    .illuminate_many = mesh_illuminate_many,
    .in_any_order = mesh_may_mix,
    .lamps = mesh_lamps,
    .tell = mesh_tell,
    .keep = mesh_keep,
    .views = mesh_views,
};
