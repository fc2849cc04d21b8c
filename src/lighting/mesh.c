/* Light meshes (Debelov and Sevastyanov 2002): lamps are asked from mesh
 * points, which surfaces then share. `ambient` stands for what comes in from
 * outside (shade/ambience.h). */
#include "base/memory.h"
#include "lighting/ambient.h"
#include "lighting/lamplight.h"
#include "lighting/mesh_close.h"
#include "lighting/mesh_diffuse.h"
#include "lighting/mesh_few.h"
#include "lighting/mesh_known.h"
#include "lighting/mesh_pixels.h"
#include "lighting/mesh_report.h"
#include "lighting/mesh_scalar.h"
#include "lighting/mesh_views.h"
#include "lighting/names.h"
#include "lightmesh/facet_mesh.h"
#include "lightmesh/indirect.h"
#include "lightmesh/outlook.h"
#include "shade/finish.h"

struct mesh_lighting {
    struct lamps lamps;
    struct ambience ambience;
    struct direct_mesh *direct;
    enum mesh_few_way few;
    struct emitters *emitters;      /* with indirect light */
    struct indirect_mesh *indirect; /* or NULL */
    struct scalar_mesh *scalar;     /* of model scalar, in place of them all */
    struct void_skeleton close;     /* what ends its bounces, if asked for */
    struct mesh_pixels pixels;      /* that lamps look at */
    struct mesh_report report;
    /* The same, whose lattices are coarser the farther from this picture's
     * camera; what mesh points hold must not depend on it, only on the
     * stamp's frame. */
    struct direct_mesh near_direct;
    struct indirect_mesh near_indirect;
    struct mesh_stamp stamp;
};

/* What a mesh needs where the scene says nothing. */
enum {
    FEW_LAMPS = 24,
    SHARP_LAMPS = 1000, /* known one by one for shadows sharp, unless few */
    MESH_BYTES = 120 * 1000 * 1000,
    INDIRECT_BYTES = 30 * 1000 * 1000, /* of them, with indirect light */
    ATTEMPTS = 12,                     /* to choose a spacing that fits */
    BOUNCES = 6,
    SCALAR_SAMPLES = 100,
    CLOSED_BOUNCES = 1, /* when the skeleton knows the rest */
    SAMPLES = 256,      /* gather rays of a mesh point, */
    ROUGH_SAMPLES = 4,  /* so many times as many where they differ much */
    ADAPTIVE_LEVELS = 2,
};

/* Where mesh points differ by more, adaptive meshes have finer ones. */
static const double adaptive_threshold = 0.2;

/* Gathering stops when the halves of the samples differ by less. */
static const double gather_error = 0.042;

/* So many cells of the indirect mesh across what is seen are fine enough. */
static const double indirect_cells = 40;

/* Where the picture shows more cells at a time the indirect mesh is coarser,
 * and may be rough: a cell serves few pixels, and no picture shows it. */
static const double crowd = 4;

/* The next attempt's spacing: half as many points on a surface. */
static const double coarser = 1.4142135623730951;

/* Pixels from mesh point to mesh point. */
static const double mesh_pixels = 20;

static double mesh_finer(const struct light_mesh_settings *said)
{
    return pow(1.3, (said->quality > 0 ? said->quality : 5) - 5);
}

static struct mesh_frame mesh_frame(const struct light_mesh_settings *said,
                                    const struct camera *camera,
                                    const struct outlook *outlook, int attempt)
{
    double spacing = mesh_pixels * outlook->pixel;
    spacing = fmin(fmax(spacing, outlook->size / 256), outlook->size / 24);
    spacing /= mesh_finer(said);
    if (said->density > 0)
        spacing = 1 / said->density;
    return (struct mesh_frame){
        .spacing = spacing * pow(coarser, attempt),
        .wanted = spacing,
        .near = 2 * outlook->distance,
        .eye = camera->location,
        .centre = outlook->centre,
        .size = outlook->size,
    };
}

/* Shadows may be as fine as pixels; what surfaces give each other is as smooth
 * as their distances are large, however large the picture is. */
static struct lattice
mesh_indirect_lattice(const struct light_mesh_settings *said,
                      const struct lattice *direct, double size)
{
    struct lattice lattice = *direct;
    double least = size / (indirect_cells * mesh_finer(said));
    while (!(said->density > 0) &&
           lattice_spacing(&lattice, lattice.usual) < least)
        lattice.spacing *= 2;
    return lattice;
}

static struct lattice frame_lattice(const struct mesh_frame *frame)
{
    return (struct lattice){ .spacing = frame->spacing,
                             .eye = frame->eye,
                             .near = frame->near };
}

/* Levels by which the indirect mesh is coarser than its lattice. */
static int mesh_coarser(const struct light_mesh_settings *said,
                        const struct world *world, const struct camera *camera,
                        const struct outlook *outlook,
                        const struct mesh_frame *frame)
{
    if (!said->indirect.on || said->density > 0)
        return 0;
    struct lattice lattice = frame_lattice(frame);
    lattice = mesh_indirect_lattice(said, &lattice, frame->size);
    return outlook_crowding(world, camera, outlook, &lattice) > crowd;
}

/* Levels are none unless they, or a threshold, are said. */
static struct refinement mesh_refinement(const struct light_mesh_settings *said)
{
    int levels = said->threshold > 0 ? ADAPTIVE_LEVELS : 0;
    return (struct refinement){
        .levels = said->levels > 0 ? said->levels : levels,
        .threshold = said->threshold > 0 ? said->threshold : adaptive_threshold,
    };
}

static struct direct_options
mesh_options(const struct light_mesh_settings *said,
             const struct mesh_frame *frame)
{
    double finer = mesh_finer(said);
    struct direct_options options = {
        .lattice = frame_lattice(frame),
        .radius = said->radius / frame->spacing,
        .refinement = mesh_refinement(said),
        .few = said->shadows == MESH_SHADOWS_SHARP ? SHARP_LAMPS : FEW_LAMPS,
        .budget = (int)(24 * finer),
        .centre = frame->centre,
        .size = frame->size,
        .finer = finer,
        .bytes = MESH_BYTES - (said->indirect.on ? INDIRECT_BYTES : 0),
    };
    return options;
}

/* How lamps are asked that are known one by one. */
static enum mesh_few_way mesh_few_way(const struct light_mesh_settings *said,
                                      size_t lamps)
{
    if (said->shadows == MESH_SHADOWS_SOFT)
        return MESH_FEW_BLENDED;
    return lamps > FEW_LAMPS ? MESH_FEW_SETTLED : MESH_FEW_ASKED;
}

/* Gathered light differs from point to point by chance, which lamps' doesn't:
 * unless the scene says another it is evened out. */
static const char gathered_interpolation[] = "smooth";

/* Indirect light. */
static void mesh_bounces(struct mesh_lighting *mesh,
                         const struct light_mesh_settings *said,
                         const struct direct_options *direct)
{
    const struct skeleton *skeleton = mesh->close.skeleton;
    int usual = skeleton ? CLOSED_BOUNCES : BOUNCES;
    int samples = said->indirect.samples, bounces = said->indirect.bounces;
    int crowded = mesh->stamp.frame.coarser;
    double finer = direct->finer;
    int enough = samples > 0 ? samples : (int)(SAMPLES * finer * finer);
    struct indirect_options options = {
        .ambience = &mesh->ambience,
        .lattice = mesh_indirect_lattice(said, &direct->lattice, direct->size),
        .interpolation = said->interpolation
                             ? direct->interpolation
                             : interpolation_find(gathered_interpolation),
        .radius = direct->radius,
        .refinement = direct->refinement,
        .bounces = bounces > 0 ? (int)fmin(bounces, BOUNCES_MAX) : usual,
        .usual = enough,
        .samples = samples > 0 || crowded > 0 ? enough : ROUGH_SAMPLES * enough,
        .error = gather_error / finer,
        .bytes = INDIRECT_BYTES,
        .close = skeleton ? mesh_close_light : NULL,
        .close_context = skeleton,
    };
    options.lattice.coarser = crowded;
    mesh->emitters = emitters_new(mesh->lamps.world);
    mesh->indirect = indirect_mesh_new(mesh->direct, mesh->emitters, &options);
}

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

static void mesh_finish(void *state)
{
    struct mesh_lighting *mesh = state;
    if (!mesh)
        return;
    mesh_pixels_free(&mesh->pixels);
    scalar_mesh_free(mesh->scalar);
    indirect_mesh_free(mesh->indirect);
    void_skeleton_free(&mesh->close);
    emitters_free(mesh->emitters);
    direct_mesh_free(mesh->direct);
    lamps_free(&mesh->lamps);
    memory_free(mesh);
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

/* Whether it was said what the points in space are to be, or where they go or
 * come from: then they light the picture. */
static bool mesh_is_said(const struct light_mesh_settings *said)
{
    return said->shadows != MESH_SHADOWS_AUTO || said->density > 0 ||
           said->radius > 0 || said->levels > 0 || said->threshold > 0 ||
           said->regions.count > 0 || said->save_file || said->load_file;
}

/* The meshes, as far as they are known. */
static bool mesh_make(struct mesh_lighting *mesh, const struct scene *scene,
                      const struct interpolation *interpolation,
                      const struct mesh_known *known, struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct point_mesh *meshes[MESHES_MAX];
    struct direct_options options = mesh_options(said, &mesh->stamp.frame);
    options.interpolation = interpolation;
    lattice_set_regions(&options.lattice, said->regions.items,
                        said->regions.count);
    lattice_make_finer(&options.lattice, options.refinement.levels);
    mesh->few = mesh_few_way(said, mesh->lamps.count);
    if (said->model == MESH_MODEL_SCALAR) {
        mesh->scalar = mesh_literal(&mesh->lamps, said, &options);
    } else {
        mesh->direct = direct_mesh_new(&mesh->lamps, &options);
        mesh->near_direct = *mesh->direct;
        mesh->near_direct.points.lattice.eye = scene->camera.location;
    }
    if (said->indirect.on && mesh->direct) {
        mesh_bounces(mesh, said, &options);
        mesh->near_indirect = *mesh->indirect;
        mesh->near_indirect.points.lattice.eye = scene->camera.location;
    }
    mesh->report = (struct mesh_report){
        .direct = mesh->direct,
        .indirect = mesh->indirect,
        .scalar = mesh->scalar,
        .spacing = lattice_spacing(&options.lattice, options.lattice.usual),
        .size = options.size,
        .bytes = MESH_BYTES,
    };
    return mesh_known_fill(known, meshes, mesh_points(mesh, meshes), diag);
}

/* Few lamps that surfaces ask themselves may look at pixels, and many if
 * nothing is said of the mesh that else would know of them. */
static struct mesh_pixels mesh_looks(const struct mesh_lighting *mesh,
                                     const struct scene *scene, double pixel)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct direct_mesh *direct = mesh->direct;
    struct mesh_pixels pixels =
        mesh_pixels_new(&mesh->lamps, scene, mesh_finer(said), pixel);
    pixels.each = direct && !direct->many;
    bool asks = pixels.each ? mesh->few == MESH_FEW_ASKED
                            : direct && direct->facets && !mesh_is_said(said);
    pixels.off = pixels.off || !asks;
    pixels.soft = pixels.soft && pixels.each && asks;
    return pixels;
}

/* What of `shadows` counts for what mesh points hold: of few lamps, and where
 * none is asked for, the same. */
static enum mesh_shadows mesh_held(const struct light_mesh_settings *said,
                                   size_t lamps)
{
    return lamps > FEW_LAMPS && said->shadows == MESH_SHADOWS_SHARP
               ? MESH_SHADOWS_SHARP
               : MESH_SHADOWS_SOFT;
}

static void *mesh_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct interpolation *interpolation =
        names_interpolation(&scene->settings, diag);
    if (!interpolation)
        return NULL;
    struct mesh_lighting *mesh = memory_new(sizeof *mesh);
    struct mesh_lighting *before = options->before;
    struct outlook outlook = outlook_of(world, scene, options->width);
    struct mesh_known known;
    mesh->ambience = ambience_new(world, scene);
    if (options->attempt == 0 && mesh->ambience.sky)
        ambient_dropped(scene, diag);
    mesh->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (options->keep || said->load_file)
        mesh->stamp =
            mesh_stamp_new(scene, mesh_held(said, mesh->lamps.count),
                           said->indirect.on, options->quality, options->seed);
    mesh->stamp.frame =
        mesh_frame(said, &scene->camera, &outlook, options->attempt);
    mesh->stamp.frame.coarser =
        mesh_coarser(said, world, &scene->camera, &outlook, &mesh->stamp.frame);
    bool done =
        mesh_known_find(&known, &mesh->stamp, options, said->load_file, diag);
    if (known.found)
        mesh->stamp = known.file.stamp;
    done =
        done && mesh_close_make(&mesh->close, world, scene,
                                before ? &before->close : NULL, options, diag);
    done = done && mesh_make(mesh, scene, interpolation, &known, diag);
    mesh->pixels = mesh_looks(mesh, scene, outlook.pixel);
    mesh->report.again =
        !(said->density > 0) && !known.name && options->attempt < ATTEMPTS;
    mesh_known_end(&known);
    if (done)
        return mesh;
    mesh_finish(mesh);
    return NULL;
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

/* The light of lamps on one side of a surface, and where most of it comes from.
 */
struct mesh_light {
    rgb light, from_there;
    vec3 direction;
};

/* What the picture's own points know of the side that the camera sees. */
static bool mesh_pixel_light(const struct mesh_lighting *mesh,
                             const struct surface *surface, vec3 side,
                             struct facet_light *light)
{
    return mesh->pixels.mesh && surface->place &&
           vec3_dot(side, surface->side) > 0 &&
           pixel_mesh_light(mesh->pixels.mesh, surface->place, surface->at,
                            side, light);
}

static struct mesh_light mesh_light(const struct mesh_lighting *mesh,
                                    const struct lamplight *asked, vec3 side,
                                    vec3 normal)
{
    const struct direct_mesh *direct = &mesh->near_direct;
    const struct surface *surface = asked->surface;
    double brilliance = surface->layer[0].finish->brilliance;
    struct facet_question question = { &direct->points.lattice, surface->at,
                                       side };
    struct facet_light own;
    struct mesh_light light = { .from_there = rgb_grey(0) };
    bool shines = mesh_shines(surface);
    if (mesh_pixel_light(mesh, surface, side, &own) ||
        (direct->facets &&
         facet_mesh_light(direct->facets, asked->worker, &question, &own))) {
        light.light = facet_light_irradiance(&own, side, normal, brilliance);
        if (shines)
            light.direction = facet_light_direction(&own, &light.from_there);
        return light;
    }
    struct mesh_blend blend;
    point_mesh_blend(&direct->points, asked->worker, surface->point, side, 1,
                     &blend);
    struct harmonics around = direct_mesh_light(&blend);
    light.light = harmonics_irradiance(&around, normal, brilliance);
    if (shines)
        light.direction = harmonics_direction(&around, &light.from_there);
    return light;
}

/* What the lamps in front of the surface, or behind it, give its first layer,
 * to be multiplied by its diffuse share. */
static rgb mesh_side(const struct mesh_lighting *mesh,
                     const struct lamplight *asked, double sign)
{
    const struct surface *surface = asked->surface;
    const struct surface_layer *layer = &surface->layer[0];
    double brilliance = layer->finish->brilliance;
    struct mesh_light light =
        mesh_light(mesh, asked, vec3_scale(surface->side, sign),
                   vec3_scale(layer->normal, sign));
    if (sign > 0)
        mesh_shine(asked, light.direction, light.from_there);
    double albedo = layer->finish->diffuse_albedo ? (brilliance + 1) / 2 : 1;
    return rgb_scale(light.light, albedo);
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
    if (mesh->direct->many)
        diffuse.irradiance = mesh_many(mesh, &light);
    else
        mesh_few_give(&mesh->near_direct, mesh->few, &mesh->pixels, &light);
    if (mesh->indirect) {
        struct diffuse_light more = mesh_diffuse(
            &mesh->near_indirect, &mesh->ambience, worker, surface);
        diffuse.ambient = more.ambient;
        diffuse.irradiance = rgb_add(diffuse.irradiance, more.irradiance);
    }
    return diffuse;
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
    mesh->report.pixels = mesh->pixels.mesh;
    mesh->report.penumbras = mesh->pixels.penumbras;
}

static bool mesh_sound(const void *state, struct diag *diag)
{
    const struct mesh_lighting *mesh = state;
    return mesh_report_sound(&mesh->report, diag);
}

static bool mesh_again(const void *state)
{
    const struct mesh_lighting *mesh = state;
    return mesh_report_again(&mesh->report);
}

static void mesh_tell(const void *state, lighting_row *row, void *context)
{
    const struct mesh_lighting *mesh = state;
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
    .sound = mesh_sound,
    .again = mesh_again,
    .tell = mesh_tell,
    .keep = mesh_keep,
    .views = mesh_views,
};
