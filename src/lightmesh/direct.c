/* The direct light mesh: see direct.h. */
#include "lightmesh/direct.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/light_tree.h"
#include "lightmesh/table.h"
#include "shade/area.h"

/* A visible share as it is kept, three for each lamp. */
enum { SHARE_ONE = 65535 };

/* Fewer points don't decide what is sharp. */
enum { AGREEING_POINTS = 3 };

static uint16_t share_pack(double share)
{
    return (uint16_t)lround(fmin(fmax(share, 0), 1) * SHARE_ONE);
}

/* Each lamp's visible share. */
static void fill_shares(const void *context, struct worker *worker,
                        const struct mesh_site *site, void *payload)
{
    const struct direct_mesh *mesh = context;
    const struct lamps *lamps = mesh->lamps;
    uint16_t *share = payload;
    for (size_t i = 0; i < lamps->count; i++, share += 3) {
        const struct lamp *lamp = &lamps->items[i];
        struct lamp_target target = { .point = site->place };
        lamp_look(lamp, lamp->light->location, site->place, &target.view);
        rgb seen = lamps_share(lamps, lamp, worker, &target);
        share[0] = share_pack(seen.r);
        share[1] = share_pack(seen.g);
        share[2] = share_pack(seen.b);
    }
}

/* One lamp, and with it the cluster it stands for. Of an area light one point
 * of its grid. */
static void add_pick(const struct direct_mesh *mesh, struct worker *worker,
                     const struct mesh_site *site,
                     const struct light_pick *pick, struct harmonics *light)
{
    const struct lamp *lamp = pick->lamp;
    struct lamp_target target = { .point = site->place };
    vec3 location = lamp->light->location;
    if (lamps_soft(mesh->lamps, lamp)) {
        struct area_grid grid = area_grid_new(lamp, site->place, 0);
        uint64_t key = random_key(site->key, (uint64_t)lamp->number);
        location =
            area_grid_point(&grid, (int)(random_unit(key) * lamp->light->size1),
                            (int)(random_unit(key + 1) * lamp->light->size2));
    }
    if (!lamp_look(lamp, location, site->place, &target.view))
        return;
    rgb arriving =
        rgb_scale(lamp->light->colour, target.view.attenuation * pick->weight);
    rgb share = lamps_share_point(mesh->lamps, lamp, worker, &target);
    if (rgb_peak(share) > 0)
        harmonics_add(light, target.view.direction, rgb_mul(arriving, share));
}

static void fill_harmonics(const void *context, struct worker *worker,
                           const struct mesh_site *site, void *payload)
{
    const struct direct_mesh *mesh = context;
    struct light_pick picks[PICKS_MAX];
    int count = light_tree_pick(mesh->tree, site->place, site->dither,
                                mesh->budget, picks);
    for (int i = 0; i < count; i++)
        add_pick(mesh, worker, site, &picks[i], payload);
}

struct direct_mesh *direct_mesh_new(const struct lamps *lamps,
                                    const struct direct_options *options)
{
    struct direct_mesh *mesh = memory_new(sizeof *mesh);
    mesh->lamps = lamps;
    mesh->many = lamps->count > (size_t)options->few;
    mesh->budget = options->budget < PICKS_MAX ? options->budget : PICKS_MAX;
    if (mesh->many)
        mesh->tree = light_tree_new(lamps, options->centre, options->size);
    mesh->points = (struct point_mesh){
        .world = lamps->world,
        .lattice = options->lattice,
        .interpolation = options->interpolation,
        .radius = options->radius > 0 ? options->radius
                                      : options->interpolation->radius,
        .payload_size = mesh->many ? sizeof(struct harmonics)
                                   : 3 * lamps->count * sizeof(uint16_t),
        .full = memory_new(sizeof(atomic_bool)),
        .fill = mesh->many ? fill_harmonics : fill_shares,
        .context = mesh,
    };
    point_mesh_start(&mesh->points, options->bytes);
    return mesh;
}

void direct_mesh_free(struct direct_mesh *mesh)
{
    if (!mesh)
        return;
    point_mesh_free(&mesh->points);
    light_tree_free(mesh->tree);
    memory_free(mesh->points.full);
    memory_free(mesh);
}

rgb direct_mesh_share(const struct direct_mesh *mesh,
                      const struct mesh_blend *blend, int number)
{
    rgb sum = rgb_grey(0);
    (void)mesh;
    for (int i = 0; i < blend->count; i++) {
        const uint16_t *share = blend->at[i].payload;
        share += 3 * number;
        rgb seen = rgb_make(share[0], share[1], share[2]);
        sum = rgb_add_scaled(sum, seen, blend->at[i].weight);
    }
    return rgb_scale(sum, 1.0 / SHARE_ONE);
}

bool direct_mesh_agrees(const struct mesh_blend *blend, int number)
{
    const uint16_t *first = blend->at[0].payload;
    uint16_t all = first[3 * number];
    if (blend->count < AGREEING_POINTS || (all != 0 && all != SHARE_ONE))
        return false;
    for (int i = 0; i < blend->count; i++) {
        const uint16_t *share = blend->at[i].payload;
        share += 3 * number;
        if (share[0] != all || share[1] != all || share[2] != all)
            return false;
    }
    return true;
}

struct harmonics direct_mesh_light(const struct mesh_blend *blend)
{
    struct harmonics sum = { { 0 }, { 0 }, { 0 } };
    for (int i = 0; i < blend->count; i++)
        harmonics_mix(&sum, blend->at[i].payload, (float)blend->at[i].weight);
    return sum;
}

rgb direct_mesh_irradiance(const struct direct_mesh *mesh,
                           struct worker *worker, vec3 place, vec3 side,
                           vec3 normal)
{
    struct mesh_blend blend;
    rgb sum = rgb_grey(0);
    point_mesh_blend(&mesh->points, worker, place, side, &blend);
    if (mesh->many) {
        struct harmonics light = direct_mesh_light(&blend);
        return harmonics_irradiance(&light, normal, 1);
    }
    for (size_t i = 0; i < mesh->lamps->count; i++) {
        const struct lamp *lamp = &mesh->lamps->items[i];
        struct lamp_view view;
        if (!lamp_look(lamp, lamp->light->location, place, &view))
            continue;
        double cosine = vec3_dot(view.direction, normal);
        if (cosine <= 0)
            continue;
        rgb light = rgb_mul(lamp->light->colour,
                            direct_mesh_share(mesh, &blend, (int)i));
        sum = rgb_add_scaled(sum, light, cosine * view.attenuation);
    }
    return sum;
}

rgb direct_mesh_arriving(const struct direct_mesh *mesh, vec3 place,
                         const void *payload)
{
    struct mesh_blend here = { .count = 1, .at = { { payload, 1 } } };
    rgb sum = rgb_grey(0);
    if (mesh->many)
        return harmonics_total(payload);
    for (size_t i = 0; i < mesh->lamps->count; i++) {
        const struct lamp *lamp = &mesh->lamps->items[i];
        struct lamp_view view;
        if (!lamp_look(lamp, lamp->light->location, place, &view))
            continue;
        rgb share = direct_mesh_share(mesh, &here, (int)i);
        sum = rgb_add_scaled(sum, rgb_mul(lamp->light->colour, share),
                             view.attenuation);
    }
    return sum;
}
