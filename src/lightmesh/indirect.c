/* The indirect light mesh: see indirect.h. */
#include "lightmesh/indirect.h"

#include "base/memory.h"
#include "lightmesh/gatherer.h"
#include "lightmesh/near_glow.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"

static struct indirect_mesh *bounce_new(const struct direct_mesh *direct,
                                        const struct emitters *emitters,
                                        const struct ambience *ambience,
                                        const struct indirect_options *options,
                                        int bounce)
{
    struct indirect_mesh *mesh = memory_new(sizeof *mesh);
    mesh->gather = (struct gather){
        .lamps = direct->lamps,
        .direct = direct,
        .view = options->view,
        .emitters = emitters,
        .ambience = ambience,
        .close = options->close,
        .close_context = options->close_context,
        .around = options->around,
        .together = options->closed && direct->lamps->count <= GATHER_EACH,
        .onward = options->onward,
        .tone = options->tone,
        .virtual_lights = options->virtual_lights,
        .picks = options->picks,
    };
    mesh->samples = options->samples;
    mesh->glow_picks = options->glow_picks;
    mesh->gather.wide = 2 / sqrt(fmax(options->samples, 1));
    if (options->bright && options->bright->count > 0)
        mesh->bright = options->bright;
    mesh->near = near_ways_new(options->near);
    mesh->near_lone = near_ways_new(options->near_lone);
    mesh->near_more = near_ways_new(options->near_more);
    mesh->near_beside = near_ways_new(NEAR_BESIDE);
    mesh->near_own = near_ways_new(options->near_own);
    mesh->own_worth = options->own_worth;
    mesh->near_onwards = near_onwards_new(
        &mesh->gather, (int)fmax(options->near, options->near_own));
    if (bounce == 1)
        mesh->near_glow = near_glow_new(direct->lamps->world, emitters,
                                        &options->lattice, &options->view);
    mesh->lone_samples = LONE_SAMPLES;
    for (int i = 1; i < bounce; i++)
        mesh->lone_samples /= LONE_PART;
    if (mesh->lone_samples < 1)
        mesh->lone_samples = 1;
    mesh->points = (struct point_mesh){
        .world = direct->lamps->world,
        .lattice = options->lattice,
        .interpolation = options->interpolation,
        .radius = options->radius > 0 ? options->radius
                                      : options->interpolation->radius,
        .least = seek_least,
        .payload_size = sizeof(struct indirect_light),
        .refinement = options->refinement,
        .light = harmonics_received,
        .fill = gatherer_fill,
        .walled = true,
        .context = mesh,
    };
    if (bounce > 1) {
        mesh->points.refinement.levels = 0;
        mesh->points.lattice.spacing *= bounce > 2 ? 4 : 2;
        if (mesh->samples > LATER_SAMPLES)
            mesh->samples = LATER_SAMPLES;
    }
    if (mesh->samples < 1)
        mesh->samples = 1;
    mesh->ways = gather_ways_new(mesh->samples);
    mesh->edge = options->edge;
    if (mesh->edge > 0 && bounce == 1)
        mesh->cells = way_cells_new(
            &mesh->ways,
            gatherer_everywhere((uint32_t)mesh->samples, mesh->bright));
    mesh->onwards = onwards_new(direct->lamps->seed, mesh->ways.count);
    mesh->gather.onwards = &mesh->onwards;
    point_mesh_start(&mesh->points, options->bytes /
                                        ((size_t)options->bounces + 3) *
                                        (bounce > 1 ? 1 : 4));
    return mesh;
}

struct indirect_mesh *indirect_mesh_new(const struct direct_mesh *direct,
                                        const struct emitters *emitters,
                                        const struct ambience *ambience,
                                        const struct indirect_options *options)
{
    struct indirect_mesh *mesh = NULL;
    for (int bounce = options->bounces; bounce >= 1; bounce--) {
        struct indirect_mesh *closer =
            bounce_new(direct, emitters, ambience, options, bounce);
        closer->next = mesh;
        closer->gather.indirect = mesh;
        mesh = closer;
    }
    return mesh;
}

void indirect_mesh_free(struct indirect_mesh *mesh)
{
    while (mesh) {
        struct indirect_mesh *next = mesh->next;
        point_mesh_free(&mesh->points);
        gather_ways_free(&mesh->ways);
        way_cells_free(&mesh->cells);
        near_ways_free(&mesh->near);
        near_ways_free(&mesh->near_lone);
        near_ways_free(&mesh->near_more);
        near_ways_free(&mesh->near_beside);
        near_ways_free(&mesh->near_own);
        onwards_free(&mesh->near_onwards);
        near_glow_free(mesh->near_glow);
        onwards_free(&mesh->onwards);
        memory_free(mesh);
        mesh = next;
    }
}

bool indirect_mesh_leaves(const struct indirect_mesh *mesh,
                          const struct receiver *receiver)
{
    const struct gather *gather = &mesh->gather;
    return (gather->close && receiver->weight < gather_worth_least) ||
           (gather->onward && receiver->weight < gather_worth_around);
}

const char *indirect_mesh_source(const struct indirect_mesh *mesh,
                                 const struct receiver *receiver)
{
    if (!indirect_mesh_leaves(mesh, receiver))
        return "mesh points around";
    return mesh->gather.close
               ? "the skeleton: the picture shows too little of it"
               : "what is usual: the picture shows too little of it";
}

bool indirect_mesh_blend(const struct indirect_mesh *mesh,
                         struct worker *worker, const struct receiver *receiver,
                         struct indirect_light *light)
{
    struct mesh_blend blend;
    point_mesh_blend(&mesh->points, worker, receiver, &blend);
    *light = indirect_light_none;
    for (int i = 0; i < blend.count; i++)
        indirect_light_mix(light, blend.at[i].payload,
                           (float)blend.at[i].weight);
    indirect_light_tint(light, blend.through);
    return !blend.here;
}

/* What glows near the receiver, which has that light else. */
static bool glow_find(const struct indirect_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct indirect_light *light,
                      struct indirect_light *glow, rgb *arriving)
{
    if (!mesh->near_glow)
        return false;
    const struct near_place place = {
        receiver->point, receiver->side,
        indirect_light_share(light, receiver->side).light,
        receiver->at_first ? 1 : fmin(receiver->weight, 1)
    };
    return near_glow_find(mesh->near_glow, &mesh->gather, worker, &place, glow,
                          arriving);
}

/* By rays along these ways, and by what glows near; without ways only where
 * that does. Returns whether anything was done. */
static bool mesh_mend(const struct indirect_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct near_ways *ways,
                      struct indirect_light *light, struct near_share *near)
{
    struct indirect_light glow;
    rgb arriving;
    bool glows = glow_find(mesh, worker, receiver, light, &glow, &arriving);
    if (!glows) {
        if (ways)
            *near = near_field_share(mesh, worker, receiver, ways, NULL, light);
        return ways != NULL;
    }
    if (receiver->at_first || receiver->weight >= gather_worth_whole)
        ways = &mesh->near_beside;
    else if (!ways)
        ways = &mesh->near_more;
    *near = near_field_share(mesh, worker, receiver, ways, &glow, light);
    near->share.light = rgb_add(near->share.light, arriving);
    indirect_light_mix(light, &glow, 1);
    return true;
}

struct near_share indirect_mesh_mend(const struct indirect_mesh *mesh,
                                     struct worker *worker,
                                     const struct receiver *receiver,
                                     const struct near_ways *ways,
                                     struct indirect_light *light)
{
    struct near_share near;
    mesh_mend(mesh, worker, receiver, ways, light, &near);
    return near;
}

struct near_share indirect_mesh_around(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       const struct near_ways *ways,
                                       struct indirect_light *light)
{
    if (indirect_mesh_blend(mesh, worker, receiver, light))
        return indirect_mesh_mend(mesh, worker, receiver, ways, light);
    return (struct near_share){ indirect_light_share(light, receiver->side),
                                0 };
}

static struct indirect_share share_left(const struct indirect_mesh *mesh,
                                        struct worker *worker,
                                        const struct receiver *receiver)
{
    struct indirect_share share = mesh->gather.around;
    gather_closes(&mesh->gather, worker, receiver, &share);
    return share;
}

struct indirect_share indirect_mesh_beyond(const struct indirect_mesh *mesh,
                                           struct worker *worker,
                                           const struct receiver *receiver)
{
    struct indirect_light light;
    if (indirect_mesh_leaves(mesh, receiver))
        return share_left(mesh, worker, receiver);
    indirect_mesh_blend(mesh, worker, receiver, &light);
    return indirect_light_bumped(&light, receiver->side, receiver->smooth,
                                 receiver->normal);
}

struct indirect_share indirect_mesh_light(const struct indirect_mesh *mesh,
                                          struct worker *worker,
                                          const struct receiver *receiver)
{
    if (indirect_mesh_leaves(mesh, receiver))
        return share_left(mesh, worker, receiver);
    const struct near_ways *ways = receiver->far_side ? &mesh->near_more
                                   : receiver->pixel  ? &mesh->near_lone
                                                      : NULL;
    struct indirect_light light;
    struct near_share near;
    if (indirect_mesh_blend(mesh, worker, receiver, &light) &&
        mesh_mend(mesh, worker, receiver, ways, &light, &near) &&
        !receiver_is_bumpy(receiver))
        return near.share;
    return indirect_light_bumped(&light, receiver->side, receiver->smooth,
                                 receiver->normal);
}

bool indirect_mesh_nearest(const struct indirect_mesh *mesh,
                           struct worker *worker,
                           const struct receiver *receiver, vec3 jitter,
                           struct indirect_share *share)
{
    rgb through;
    const struct indirect_light *nearest =
        point_mesh_nearest(&mesh->points, worker, receiver, jitter, &through);
    if (!nearest)
        return false;
    *share = indirect_light_share(nearest, receiver->normal);
    share->light = rgb_mul(share->light, through);
    share->open *= rgb_brightness(through);
    return true;
}
