/* The paper's equations: see scalar.h. */
#include "lightmesh/scalar.h"

#include "base/memory.h"
#include "base/random.h"
#include "base/warp.h"
#include "lightmesh/gather.h"
#include "lightmesh/gather_paint.h"
#include "shade/finish.h"
#include "shade/shadow.h"

/* What a mesh point holds. */
struct scalar_record {
    float r, g, b;
};

static void record_set(void *payload, rgb light)
{
    struct scalar_record *record = payload;
    *record = (struct scalar_record){ (float)light.r, (float)light.g,
                                      (float)light.b };
}

rgb scalar_held(const void *payload)
{
    const struct scalar_record *record = payload;
    return rgb_make((double)record->r, (double)record->g, (double)record->b);
}

rgb scalar_lamp(const struct lamp *lamp, vec3 point, vec3 *direction)
{
    struct lamp_view view;
    vec3 location = lamp->light->location;
    bool lit = lamp_look(lamp, location, point, &view);
    double r = vec3_length(vec3_sub(location, point));
    *direction = view.direction;
    return lit ? rgb_scale(lamp->light->colour,
                           view.attenuation / scalar_phi1(r))
               : rgb_grey(0);
}

rgb scalar_direct(const struct scalar_mesh *mesh, struct worker *worker,
                  vec3 place)
{
    rgb sum = rgb_grey(0);
    for (size_t i = 0; i < mesh->lamps->count; i++) {
        const struct lamp *lamp = &mesh->lamps->items[i];
        struct lamp_target target = { .point = place };
        vec3 direction;
        rgb light = scalar_lamp(lamp, place, &direction);
        if (!lamp_look(lamp, lamp->light->location, place, &target.view))
            continue;
        rgb seen = lamps_share_point(mesh->lamps, lamp, worker, &target);
        sum = rgb_add(sum, rgb_mul(light, seen));
    }
    return sum;
}

/* The mean over D_y of what mesh points hold: (3), and (5) with phi5 = 1. */
static rgb points_mean(const struct point_mesh *points,
                       struct lattice_view view, struct worker *worker,
                       const struct surface *surface)
{
    struct mesh_blend blend;
    rgb sum = rgb_grey(0);
    const struct receiver receiver = { .point = surface->point,
                                       .side = surface->side,
                                       .smooth = surface->side,
                                       .normal = surface->side,
                                       .view = view,
                                       .weight = 1 };
    point_mesh_blend(points, worker, &receiver, &blend);
    for (int i = 0; i < blend.count; i++) {
        sum = rgb_add_scaled(sum, scalar_held(blend.at[i].payload),
                             blend.at[i].weight);
    }
    return sum;
}

rgb scalar_mean(const struct scalar_mesh *mesh, struct worker *worker,
                const struct surface *surface)
{
    return rgb_add(surface_glow(surface),
                   points_mean(&mesh->direct, mesh->view, worker, surface));
}

/* L(x, w) of (4). */
static rgb scalar_incoming(const struct scalar_mesh *mesh,
                           struct worker *worker, const struct ray *ray)
{
    struct gather gather = { .lamps = mesh->lamps };
    struct intersection at;
    struct surface surface;
    worker->counters.shadow_rays++;
    if (!world_closest(mesh->lamps->world, ray, surface_offset(ray->origin),
                       RAY_GATHER, &at))
        return rgb_grey(0);
    gather_surface(&gather, ray, &at, &surface);
    return scalar_mean(mesh, worker, &surface);
}

rgb scalar_indirect(const struct scalar_mesh *mesh, struct worker *worker,
                    vec3 place, uint64_t key)
{
    rgb sum = rgb_grey(0);
    int edge = (int)sqrt(mesh->samples);
    for (int i = 0; i < edge * edge && !worker_stopped(worker); i++) {
        uint64_t sample = random_key(key, (uint64_t)i);
        double u[2] = { (i % edge + random_unit(sample)) / edge,
                        (i / edge + random_unit(sample + 1)) / edge };
        struct ray ray = { place, warp_sphere(u) };
        sum = rgb_add(sum, scalar_incoming(mesh, worker, &ray));
    }
    return rgb_scale(sum, 4 * WARP_PI / fmax(edge * edge, 1));
}

rgb scalar_indirect_mean(const struct scalar_mesh *mesh, struct worker *worker,
                         const struct surface *surface)
{
    return mesh->samples
               ? points_mean(&mesh->indirect, mesh->view, worker, surface)
               : rgb_grey(0);
}

static rgb record_light(const void *context, vec3 place, vec3 normal,
                        const void *payload)
{
    (void)context;
    (void)place;
    (void)normal;
    return scalar_held(payload);
}

static void fill_direct(const void *context, struct worker *worker,
                        const struct mesh_site *site, void *payload)
{
    record_set(payload, scalar_direct(context, worker, site->place));
}

static void fill_indirect(const void *context, struct worker *worker,
                          const struct mesh_site *site, void *payload)
{
    record_set(payload,
               scalar_indirect(context, worker, site->place, site->key));
}

static struct point_mesh scalar_points(const struct scalar_mesh *mesh,
                                       const struct direct_options *options)
{
    double own = options->interpolation->radius;
    return (struct point_mesh){
        .world = mesh->lamps->world,
        .lattice = options->lattice,
        .interpolation = options->interpolation,
        .radius = options->radius > 0 ? options->radius : own,
        .payload_size = sizeof(struct scalar_record),
        .refinement = options->refinement,
        .light = record_light,
        .context = mesh,
    };
}

struct scalar_mesh *scalar_mesh_new(const struct lamps *lamps,
                                    const struct direct_options *options,
                                    int samples)
{
    struct scalar_mesh *mesh = memory_new(sizeof *mesh);
    mesh->lamps = lamps;
    mesh->samples = samples;
    mesh->direct = scalar_points(mesh, options);
    mesh->view = options->view;
    mesh->direct.fill = fill_direct;
    mesh->indirect = mesh->direct;
    mesh->indirect.fill = fill_indirect;
    point_mesh_start(&mesh->direct, options->bytes / 2);
    point_mesh_start(&mesh->indirect, options->bytes / 2);
    return mesh;
}

void scalar_mesh_free(struct scalar_mesh *mesh)
{
    if (!mesh)
        return;
    point_mesh_free(&mesh->direct);
    point_mesh_free(&mesh->indirect);
    memory_free(mesh);
}
