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
    struct mesh_report report;
    /* The same, whose lattices are coarser the farther from this picture's
     * camera; what mesh points hold must not depend on it, only on the
     * stamp's frame. */
    struct direct_mesh near_direct;
    struct indirect_mesh near_indirect;
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

/* The meshes, as far as they are known. */
static bool mesh_make(struct mesh_lighting *mesh, const struct scene *scene,
                      const struct mesh_known *known, struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const struct point_mesh *meshes[MESHES_MAX];
    struct direct_options *options = &mesh->plan.direct;
    if (said->model == MESH_MODEL_SCALAR) {
        mesh->scalar = mesh_literal(&mesh->lamps, said, options);
    } else {
        mesh->direct = direct_mesh_new(&mesh->lamps, options);
        mesh->near_direct = *mesh->direct;
        mesh->near_direct.points.lattice.eye = scene->camera.location;
    }
    if (mesh->plan.indirect.bounces > 0 && mesh->direct) {
        mesh->emitters = emitters_new(mesh->lamps.world);
        mesh->indirect =
            indirect_mesh_new(mesh->direct, mesh->emitters, &mesh->ambience,
                              &mesh->plan.indirect);
        mesh->near_indirect = *mesh->indirect;
        mesh->near_indirect.points.lattice.eye = scene->camera.location;
    }
    mesh->report = (struct mesh_report){
        .direct = mesh->direct,
        .indirect = mesh->indirect,
        .scalar = mesh->scalar,
        .spacing = lattice_spacing(&options->lattice, options->lattice.usual),
        .size = options->size,
        .bytes = MESH_BYTES,
    };
    return mesh_known_fill(known, meshes, mesh_points(mesh, meshes), diag);
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
            mesh_stamp_new(scene, plan_held(said, mesh->lamps.count),
                           said->indirect.on, options->quality, options->seed);
    mesh->stamp.frame = plan_frame(world, scene, &outlook, options->attempt);
    bool done =
        mesh_known_find(&known, &mesh->stamp, options, said->load_file, diag);
    if (known.found)
        mesh->stamp = known.file.stamp;
    done =
        done && mesh_close_make(&mesh->close, world, scene,
                                before ? &before->close : NULL, options, diag);
    const struct skeleton *skeleton = mesh->close.skeleton;
    mesh->plan =
        plan_new(scene, &mesh->lamps, &mesh->stamp.frame, interpolation,
                 skeleton ? mesh_close_light : NULL, skeleton);
    done = done && mesh_make(mesh, scene, &known, diag);
    mesh->pixels =
        mesh_pixels_new(&mesh->lamps, scene, &mesh->plan, outlook.pixel);
    mesh->report.again = !(said->density > 0) && !known.name &&
                         options->attempt < SPACING_ATTEMPTS;
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
        mesh_few_give(&mesh->near_direct, mesh->plan.lamps, &mesh->pixels,
                      &light);
    if (mesh->indirect) {
        struct diffuse_light more = mesh_diffuse(
            &mesh->near_indirect, &mesh->ambience, worker, surface);
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
    .sound = mesh_sound,
    .again = mesh_again,
    .tell = mesh_tell,
    .keep = mesh_keep,
    .views = mesh_views,
};
