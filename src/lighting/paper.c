/* The light meshes of the paper to the letter (Debelov and Sevastyanov 2002,
 * equations (1) to (8); lightmesh/scalar.h): mesh points hold a number for each
 * colour, and a place takes the plain mean of those around it. A look, and what
 * `mesh` is to be compared with. A scene that says `model scalar` means it. */
#include "base/memory.h"
#include "lighting/lamplight.h"
#include "lighting/mesh_known.h"
#include "lighting/mesh_report.h"
#include "lighting/mesh_views.h"
#include "lighting/names.h"
#include "lightmesh/outlook.h"
#include "lightmesh/plan.h"
#include "lightmesh/scalar.h"
#include "lightmesh/tuning.h"

enum { PAPER_MESHES = 2 };

struct paper_lighting {
    struct lamps lamps;
    struct scalar_mesh *mesh;
    struct mesh_stamp stamp;
    struct mesh_report report;
};

static void paper_finish(void *state)
{
    struct paper_lighting *paper = state;
    if (!paper)
        return;
    scalar_mesh_free(paper->mesh);
    lamps_free(&paper->lamps);
    memory_free(paper);
}

/* D(y) of (3) is a sphere, and all of its points count alike. */
static const struct interpolation *
paper_interpolation(const struct scene *scene, struct diag *diag)
{
    const struct interpolation *said =
        names_interpolation(&scene->settings, diag);
    bool sphere = said && (!scene->settings.light_mesh.interpolation ||
                           said == interpolation_find("spherical"));
    return sphere ? interpolation_find("mean") : said;
}

/* DLM and ILM, in the order in which files hold them. */
static size_t paper_points(const struct paper_lighting *paper,
                           const struct point_mesh *meshes[PAPER_MESHES])
{
    meshes[0] = &paper->mesh->direct;
    meshes[1] = &paper->mesh->indirect;
    return paper->mesh->samples > 0 ? 2 : 1;
}

static void paper_make(struct paper_lighting *paper, const struct scene *scene,
                       const struct interpolation *interpolation)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    int samples =
        said->indirect.samples ? said->indirect.samples : SCALAR_SAMPLES;
    struct plan plan = plan_new(scene, &paper->lamps, &paper->stamp.frame,
                                interpolation, NULL, NULL);
    plan.direct.bytes = MESH_BYTES;
    plan.direct.view.eye = scene->camera.location;
    paper->mesh = scalar_mesh_new(&paper->lamps, &plan.direct,
                                  said->indirect.on ? samples : 0);
    paper->report.spacing = plan.frame.spacing;
    paper->report.size = plan.frame.size;
    mesh_report_add(&paper->report, "direct", &paper->mesh->direct,
                    &plan.direct.view);
    if (paper->mesh->samples > 0)
        mesh_report_add(&paper->report, "bounce 1", &paper->mesh->indirect,
                        &plan.direct.view);
}

/* Returns false after an error was printed. */
static bool paper_begin(struct paper_lighting *paper, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    const struct point_mesh *meshes[PAPER_MESHES];
    const struct interpolation *interpolation =
        paper_interpolation(scene, diag);
    struct mesh_known known;
    bool done = mesh_known_find(&known, &paper->stamp, options,
                                scene->settings.light_mesh.load_file, diag) &&
                interpolation;
    if (done && known.found)
        paper->stamp = known.file.stamp;
    if (done) {
        mesh_known_same(&known, &paper->stamp, options);
        paper_make(paper, scene, interpolation);
    }
    done = done &&
           mesh_known_fill(&known, meshes, paper_points(paper, meshes), diag);
    mesh_known_end(&known);
    return done;
}

/* What mesh points hold is told from that of `mesh` by the model. */
static struct mesh_stamp paper_stamp(const struct paper_lighting *paper,
                                     const struct scene *scene,
                                     const struct lighting_options *options)
{
    struct scene literal = *scene;
    struct light_mesh_settings *said = &literal.settings.light_mesh;
    said->model = MESH_MODEL_SCALAR;
    return mesh_stamp_new(&literal, plan_held(said, paper->lamps.count),
                          said->indirect.on, options->quality, options->seed);
}

static void *paper_start(const struct world *world, const struct scene *scene,
                         const struct lighting_options *options,
                         struct diag *diag)
{
    struct paper_lighting *paper = memory_new(sizeof *paper);
    struct outlook outlook = outlook_of(world, scene, options->width);
    paper->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (options->keep || scene->settings.light_mesh.load_file)
        paper->stamp = paper_stamp(paper, scene, options);
    const struct survey none = { .open = 1 };
    paper->stamp.frame = plan_frame(scene, &outlook, &none, PLAN_ALONE, 0);
    if (paper_begin(paper, scene, options, diag))
        return paper;
    paper_finish(paper);
    return NULL;
}

/* (2): the mean around the point times E / phi1 and the cosine of each lamp;
 * (5) is without direction. */
static struct diffuse_light paper_illuminate(const void *state,
                                             struct worker *worker,
                                             const struct surface *surface,
                                             light_visit *visit, void *context)
{
    const struct paper_lighting *paper = state;
    if (surface->count == 0)
        return (struct diffuse_light){ rgb_grey(0), rgb_grey(0) };
    rgb mean = scalar_mean(paper->mesh, worker, surface);
    for (size_t i = 0; i < paper->lamps.count; i++) {
        struct light_sample sample = { .highlights = false };
        rgb lamp = scalar_lamp(&paper->lamps.items[i], surface->point,
                               &sample.direction);
        sample.colour = rgb_mul(mean, lamp);
        if (rgb_peak(sample.colour) > 0 &&
            surface_faces(surface, sample.direction))
            visit(context, &sample);
    }
    return (struct diffuse_light){ .irradiance = scalar_indirect_mean(
                                       paper->mesh, worker, surface) };
}

static struct lighting_kept paper_keep(const void *state)
{
    const struct paper_lighting *paper = state;
    const struct point_mesh *meshes[PAPER_MESHES];
    size_t count = paper_points(paper, meshes);
    struct lighting_kept kept = { .inside = false };
    kept.bytes = mesh_file_pack(&paper->stamp, meshes, count, &kept.size);
    kept.family = mesh_stamp_family(&paper->stamp);
    return kept;
}

static const struct lamps *paper_lamps(const void *state)
{
    const struct paper_lighting *paper = state;
    return &paper->lamps;
}

static void paper_tell(const void *state, lighting_row *row, void *context)
{
    const struct paper_lighting *paper = state;
    mesh_report_tell(&paper->report, row, context);
}

static void paper_give_direct(const void *state, struct show *show)
{
    const struct paper_lighting *paper = state;
    mesh_show_scalar(&paper->mesh->direct, show);
}

static void paper_give_indirect(const void *state, struct show *show)
{
    const struct paper_lighting *paper = state;
    mesh_show_scalar(&paper->mesh->indirect, show);
}

static const struct lighting_view paper_views[] = {
    { "mesh", "mesh points, by the light of lamps", paper_give_direct, NULL },
    { "mesh:indirect", "by the light of surfaces", paper_give_indirect,
      "--mesh-indirect on" },
    { NULL, NULL, NULL },
};

const struct lighting paper_lighting = {
    .name = "paper",
    .help = "light meshes as in their paper, to the letter: a look",
    .start = paper_start,
    .finish = paper_finish,
    .illuminate = paper_illuminate,
    .lamps = paper_lamps,
    .tell = paper_tell,
    .keep = paper_keep,
    .views = paper_views,
};
