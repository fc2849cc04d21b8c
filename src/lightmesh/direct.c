/* The direct light mesh: see direct.h. */
#include "lightmesh/direct.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/facet_mesh.h"
#include "lightmesh/light_tree.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"

/* A visible share as it is kept, three for each lamp. */
enum { SHARE_ONE = 65535 };

/* A mesh point under few lamps keeps the sets of struct direct_verdict, each
 * of so many words, then the shares. */
static size_t few_words(const struct direct_mesh *mesh)
{
    return (mesh->lamps->count + 63) / 64;
}

static size_t few_bytes(const struct direct_mesh *mesh)
{
    return 3 * few_words(mesh) * sizeof(uint64_t) +
           3 * mesh->lamps->count * sizeof(uint16_t);
}

static const uint16_t *few_share(const struct direct_mesh *mesh,
                                 const void *payload, size_t number)
{
    const uint64_t *sets = payload;
    return (const uint16_t *)(sets + 3 * few_words(mesh)) + 3 * number;
}

static uint16_t share_pack(double share)
{
    return (uint16_t)lround(fmin(fmax(share, 0), 1) * SHARE_ONE);
}

/* The visible share, and how much light it is a share of. */
static double fill_share(const struct direct_mesh *mesh, struct worker *worker,
                         const struct mesh_site *site, size_t number,
                         uint16_t share[3])
{
    const struct lamp *lamp = &mesh->lamps->items[number];
    struct lamp_target target = { .point = site->place };
    bool there =
        lamp_look(lamp, lamp->light->location, site->place, &target.view);
    rgb seen = lamps_share_fine(mesh->lamps, lamp, worker, &target);
    share[0] = share_pack(seen.r);
    share[1] = share_pack(seen.g);
    share[2] = share_pack(seen.b);
    return there ? target.view.attenuation * rgb_peak(lamp->light->colour) : 0;
}

/* Each lamp's visible share. Errors of lamps are independent, and so add up
 * like the sides of right angles: n of them may each be 1/sqrt(n) of what is
 * allowed. */
static void fill_shares(const void *context, struct worker *worker,
                        const struct mesh_site *site, void *payload)
{
    const struct direct_mesh *mesh = context;
    size_t count = mesh->lamps->count, words = few_words(mesh);
    double light[FEW_MAX], sum = 0;
    uint64_t *lit = payload, *dark = lit + words, *faint = dark + words;
    uint16_t *share = (uint16_t *)(faint + words);
    for (size_t i = 0; i < count; i++, share += 3) {
        uint64_t bit = 1ull << (i % 64);
        light[i] = fill_share(mesh, worker, site, i, share);
        sum += light[i] * share[1] / SHARE_ONE;
        if ((share[0] & share[1] & share[2]) == SHARE_ONE)
            lit[i / 64] |= bit;
        if ((share[0] | share[1] | share[2]) == 0)
            dark[i / 64] |= bit;
    }
    for (size_t i = 0; count > FEW_LAMPS && i < count; i++)
        if (light[i] * sqrt((double)count) < faint_error * sum)
            faint[i / 64] |= 1ull << (i % 64);
}

/* One lamp, and with it the cluster it stands for. Of an area light one point
 * of its grid. */
static void add_pick(const struct direct_mesh *mesh, struct worker *worker,
                     const struct mesh_site *site,
                     const struct light_pick *pick, struct harmonics *light)
{
    const struct lamp *lamp = pick->lamp;
    struct lamp_target target = { .point = site->place };
    uint64_t key = random_key(site->key, (uint64_t)lamp->number);
    double u[2] = { random_unit(key), random_unit(key + 1) };
    vec3 location = lamps_location(mesh->lamps, lamp, site->place, u);
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

rgb direct_mesh_share(const struct direct_mesh *mesh,
                      const struct mesh_blend *blend, int number)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < blend->count; i++) {
        const uint16_t *share =
            few_share(mesh, blend->at[i].payload, (size_t)number);
        rgb seen = rgb_make(share[0], share[1], share[2]);
        sum = rgb_add_scaled(sum, seen, blend->at[i].weight);
    }
    return rgb_scale(sum, 1.0 / SHARE_ONE);
}

/* Few lamps: their light on a surface. */
static rgb shares_irradiance(const struct direct_mesh *mesh,
                             const struct mesh_blend *blend, vec3 place,
                             vec3 normal)
{
    rgb sum = rgb_grey(0);
    for (size_t i = 0; i < mesh->lamps->count; i++) {
        const struct lamp *lamp = &mesh->lamps->items[i];
        struct lamp_view view;
        if (!lamp_look(lamp, lamp->light->location, place, &view))
            continue;
        double cosine = vec3_dot(view.direction, normal);
        if (cosine <= 0)
            continue;
        rgb light = rgb_mul(lamp->light->colour,
                            direct_mesh_share(mesh, blend, (int)i));
        sum = rgb_add_scaled(sum, light, cosine * view.attenuation);
    }
    return sum;
}

/* One mesh point, without touching the room for others. */
static void blend_alone(struct mesh_blend *blend, const void *payload)
{
    blend->count = 1;
    blend->at[0].payload = payload;
    blend->at[0].weight = 1;
}

static rgb shares_light(const void *context, vec3 place, vec3 normal,
                        const void *payload)
{
    struct mesh_blend here;
    blend_alone(&here, payload);
    return shares_irradiance(context, &here, place, normal);
}

static double harmonics_amount(const void *payload)
{
    const struct harmonics *light = payload;
    return (double)(light->r[0] + light->g[0] + light->b[0]);
}

struct direct_mesh *direct_mesh_new(const struct lamps *lamps,
                                    const struct direct_options *options)
{
    struct direct_mesh *mesh = memory_new(sizeof *mesh);
    mesh->lamps = lamps;
    mesh->many = options->many;
    mesh->budget = (int)fmin(options->budget, PICKS_MAX);
    if (mesh->many)
        mesh->tree = light_tree_new(lamps, options->centre, options->size);
    mesh->points = (struct point_mesh){
        .world = lamps->world,
        .lattice = options->lattice,
        .interpolation = options->interpolation,
        .radius = options->radius > 0 ? options->radius
                                      : options->interpolation->radius,
        .payload_size = mesh->many ? sizeof(struct harmonics) : few_bytes(mesh),
        .amount = mesh->many ? harmonics_amount : NULL,
        .refinement = options->refinement,
        .light = mesh->many ? harmonics_received : shares_light,
        .fill = mesh->many ? fill_harmonics : fill_shares,
        .context = mesh,
    };
    size_t bytes = options->bytes;
    if (options->surfaces) {
        bytes -= bytes / SURFACE_PART;
        mesh->facets =
            facet_mesh_new(lamps, mesh->tree, &options->lattice,
                           options->budget, options->bytes / SURFACE_PART);
    }
    point_mesh_start(&mesh->points, bytes);
    return mesh;
}

void direct_mesh_free(struct direct_mesh *mesh)
{
    if (!mesh)
        return;
    facet_mesh_free(mesh->facets);
    point_mesh_free(&mesh->points);
    light_tree_free(mesh->tree);
    memory_free(mesh);
}

void direct_mesh_judge(const struct direct_mesh *mesh,
                       const struct mesh_blend *blend,
                       struct direct_verdict *verdict)
{
    size_t words = few_words(mesh);
    const uint64_t *first = blend->at[0].payload;
    for (size_t w = 0; w < words; w++) {
        verdict->lit[w] = first[w];
        verdict->dark[w] = first[w + words];
        verdict->faint[w] = first[w + 2 * words];
    }
    for (int i = 1; i < blend->count; i++) {
        const uint64_t *sets = blend->at[i].payload;
        for (size_t w = 0; w < words; w++) {
            verdict->lit[w] &= sets[w];
            verdict->dark[w] &= sets[w + words];
            verdict->faint[w] &= sets[w + 2 * words];
        }
    }
}

bool direct_mesh_agrees(const struct mesh_blend *blend)
{
    return blend->count >= AGREEING_POINTS;
}

struct harmonics direct_mesh_light(const struct mesh_blend *blend)
{
    struct harmonics sum = { { 0 }, { 0 }, { 0 } };
    for (int i = 0; i < blend->count; i++)
        harmonics_mix(&sum, blend->at[i].payload, (float)blend->at[i].weight);
    return sum;
}

static rgb blend_irradiance(const struct direct_mesh *mesh,
                            const struct mesh_blend *blend, vec3 place,
                            vec3 normal)
{
    if (mesh->many) {
        struct harmonics light = direct_mesh_light(blend);
        return harmonics_irradiance(&light, normal, 1);
    }
    return shares_irradiance(mesh, blend, place, normal);
}

rgb direct_mesh_irradiance(const struct direct_mesh *mesh,
                           struct worker *worker,
                           const struct receiver *receiver)
{
    struct mesh_blend blend;
    point_mesh_blend(&mesh->points, worker, receiver, &blend);
    return blend_irradiance(mesh, &blend, receiver->point, receiver->normal);
}

rgb direct_mesh_nearest(const struct direct_mesh *mesh, struct worker *worker,
                        const struct receiver *receiver, vec3 jitter)
{
    const void *payload =
        point_mesh_nearest(&mesh->points, worker, receiver, jitter, NULL);
    if (!payload)
        return direct_mesh_irradiance(mesh, worker, receiver);
    struct mesh_blend blend;
    blend_alone(&blend, payload);
    return blend_irradiance(mesh, &blend, receiver->point, receiver->normal);
}

rgb direct_mesh_arriving(const struct direct_mesh *mesh, vec3 place,
                         const void *payload)
{
    struct mesh_blend here;
    rgb sum = rgb_grey(0);
    blend_alone(&here, payload);
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
