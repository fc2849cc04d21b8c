/* The indirect light mesh: see indirect.h. */
#include "lightmesh/indirect.h"

#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/near_field.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"

/* A mesh point that gathers. */
struct gatherer {
    const struct indirect_mesh *mesh;
    struct worker *worker;
    const struct mesh_site *site;
    uint32_t wall_share;   /* of ways into a wall one of so many is gone */
    uint32_t count, aimed; /* rays, and how many of them to bright places */
    struct aim aim;
};

/* What came from the only wall near is kept apart: it lights nothing, and is
 * rougher. */
struct gathered {
    struct indirect_light light, wall;
};

/* All ways are equally likely, on a surface those before it; but of those into
 * the only wall near, which gets nothing from there, few are gone, and those to
 * bright places are gone more often. */
static double gatherer_density(const struct gatherer *gatherer, vec3 way)
{
    const struct mesh_site *site = gatherer->site;
    if (site->lone)
        return 1 / (2 * WARP_PI);
    bool wall = vec3_dot(way, site->wall) > 0;
    double aimed = (double)gatherer->aimed / gatherer->count;
    double even = (1 - aimed) / (4 * WARP_PI);
    if (wall)
        return even / gatherer->wall_share;
    return aimed > 0 ? even + aimed * aim_density(&gatherer->aim, way) : even;
}

static vec3 way_drawn(uint64_t key, uint32_t index)
{
    struct draws draws = { key, index };
    double u[2];
    draw_pair(&draws, GATHER_DIRECTION, u);
    return warp_sphere(u);
}

static vec3 gatherer_way(const struct gatherer *gatherer,
                         const struct draws *draws)
{
    const struct mesh_site *site = gatherer->site;
    if (!site->lone && gatherer->mesh->ways)
        return gatherer->mesh->ways[draws->index];
    vec3 way = way_drawn(draws->key, draws->index);
    double behind = site->lone ? vec3_dot(way, site->normal) : 0;
    return behind < 0 ? vec3_along(way, site->normal, -2 * behind) : way;
}

/* Gather rays that set out together. */
struct gatherer_rays {
    struct rays rays;
    struct rays_span span;
    struct draws draws[RAY_LANES];
    struct world_hit hits[RAY_LANES];
    unsigned count;
};

/* One gather ray. What glows counts by how likely it is to be found so. */
static void gatherer_look(const struct gatherer *gatherer,
                          const struct gatherer_rays *sent, unsigned i,
                          struct gathered *sum)
{
    const struct gather *gather = &gatherer->mesh->gather;
    const struct ray ray = rays_at(&sent->rays, (int)i);
    double density = gatherer_density(gatherer, ray.direction);
    bool wall = vec3_dot(ray.direction, gatherer->site->wall) > 0;
    struct gathered_ray found = { .at = { .leaf = NULL } };
    if (sent->hits[i].leaf)
        world_describe(&ray, &sent->hits[i], &found.at);
    gather_met(gather, gatherer->worker, &ray, &sent->draws[i], &found);
    indirect_light_add(wall ? &sum->wall : &sum->light, ray.direction,
                       gather_balanced(gather, &ray, density, &found),
                       found.open, density);
}

/* Those that are waiting. */
static void gatherer_flush(const struct gatherer *gatherer,
                           struct gatherer_rays *sent, struct gathered *sum)
{
    double from = surface_offset(gatherer->site->place);
    for (unsigned i = 0; i < sent->count; i++) {
        sent->span.near[i] = from;
        sent->span.far[i] = (double)INFINITY;
    }
    gatherer->worker->counters.shadow_rays += sent->count;
    world_closest_many(gatherer->mesh->points.world, &sent->rays, &sent->span,
                       sent->count, RAY_REFLECTION, sent->hits);
    for (unsigned i = 0; i < sent->count; i++)
        gatherer_look(gatherer, sent, i, sum);
    sent->count = 0;
}

static void gatherer_send(const struct gatherer *gatherer,
                          const struct draws *draws, vec3 way,
                          struct gatherer_rays *sent, struct gathered *sum)
{
    rays_set(&sent->rays, (int)sent->count, gatherer->site->place, way);
    sent->draws[sent->count++] = *draws;
    if (sent->count == RAY_LANES)
        gatherer_flush(gatherer, sent, sum);
}

/* The same for a place on something that glows. */
static void gatherer_pick(const struct gatherer *gatherer,
                          const struct draws *draws,
                          struct indirect_light *light)
{
    struct gathered_glow found;
    if (gather_pick(&gatherer->mesh->gather, gatherer->worker,
                    gatherer->site->place, draws, &found))
        indirect_light_add(light, found.direction, found.light, 0,
                           found.density +
                               gatherer_density(gatherer, found.direction));
}

/* All mesh points look in the same directions, but for the corners of a cell,
 * which have eight parts of one large set: neighbours don't differ by chance,
 * and between them a place has a set as large. */
static struct draws gatherer_draws(const struct gatherer *gatherer,
                                   uint32_t sample)
{
    const struct mesh_site *site = gatherer->site;
    if (site->lone)
        return (struct draws){ site->key, sample };
    uint32_t part = (uint32_t)(site->dither * 8);
    return (struct draws){ gatherer->mesh->gather.lamps->seed,
                           part * gatherer->mesh->set + sample };
}

/* Number `i` in an order in which neighbours go nearly the same way. */
static uint32_t gatherer_sample(const struct gatherer *gatherer, uint32_t i)
{
    const struct indirect_mesh *mesh = gatherer->mesh;
    uint32_t part = (uint32_t)(gatherer->site->dither * 8);
    return gatherer->site->lone || !mesh->order
               ? i
               : mesh->order[part * mesh->set + i];
}

/* The sum of what is sent everywhere. */
static void gatherer_even(const struct gatherer *gatherer,
                          struct gatherer_rays *sent, struct gathered *sum)
{
    uint32_t end = gatherer->count - gatherer->aimed;
    uint32_t wall_end = end / gatherer->wall_share;
    for (uint32_t i = 0;
         i < gatherer->count && !worker_stopped(gatherer->worker); i++) {
        uint32_t sample = gatherer_sample(gatherer, i);
        if (sample >= end)
            continue;
        struct draws draws = gatherer_draws(gatherer, sample);
        vec3 way = gatherer_way(gatherer, &draws);
        bool wall = vec3_dot(way, gatherer->site->wall) > 0;
        if (!wall || sample < wall_end)
            gatherer_send(gatherer, &draws, way, sent, sum);
    }
    gatherer_flush(gatherer, sent, sum);
}

/* And of what is sent to bright places. */
static void gatherer_aim(const struct gatherer *gatherer,
                         struct gatherer_rays *sent, struct gathered *sum)
{
    uint32_t i = gatherer->count - gatherer->aimed;
    for (; i < gatherer->count && !worker_stopped(gatherer->worker); i++) {
        struct draws draws = gatherer_draws(gatherer, i);
        double u[2];
        int which;
        draw_pair(&draws, GATHER_DIRECTION, u);
        vec3 way = aim_way(&gatherer->aim, u, &which);
        if (!(vec3_dot(way, gatherer->site->wall) > 0))
            gatherer_send(gatherer, &draws, way, sent, sum);
    }
    gatherer_flush(gatherer, sent, sum);
}

static struct gathered gatherer_mean(const struct gatherer *gatherer)
{
    struct gathered sum = { indirect_light_none, indirect_light_none };
    uint32_t count = gatherer->count;
    struct gatherer_rays sent = { .count = 0 };
    gatherer_even(gatherer, &sent, &sum);
    gatherer_aim(gatherer, &sent, &sum);
    if (emitters_any(gatherer->mesh->gather.emitters))
        for (uint32_t i = 0; i < count && !worker_stopped(gatherer->worker);
             i++) {
            struct draws draws = gatherer_draws(gatherer, i);
            gatherer_pick(gatherer, &draws, &sum.light);
        }
    indirect_light_scale(&sum.light, 1 / (float)count);
    indirect_light_scale(&sum.wall, 1 / (float)count);
    return sum;
}

static uint32_t lone_samples(const struct indirect_mesh *mesh,
                             const struct mesh_site *site)
{
    double worth = fmin(site->worth / gather_worth_whole, 1);
    return (uint32_t)ceil(worth * worth * mesh->lone_samples);
}

/* All points send as many rays: to leave off where they agree would miss what
 * is bright and seldom met. */
static void fill_gather(const void *context, struct worker *worker,
                        const struct mesh_site *site, void *payload)
{
    const struct indirect_mesh *mesh = context;
    struct gatherer gatherer = { .mesh = mesh,
                                 .worker = worker,
                                 .site = site,
                                 .wall_share = WALL_PART,
                                 .count = (uint32_t)mesh->samples };
    uint32_t lone = lone_samples(mesh, site);
    if (site->lone && lone < gatherer.count)
        gatherer.count = lone;
    if (gatherer.count % WALL_PART > 0)
        gatherer.wall_share = 1;
    if (mesh->bright && !site->lone) {
        gatherer.aimed = gatherer.count / WALL_PART * BRIGHT_RAYS;
        aim_take(&gatherer.aim, mesh->bright, site->place);
    }
    struct gathered light = gatherer_mean(&gatherer);
    indirect_light_mix(&light.light, &light.wall, 1);
    *(struct indirect_light *)payload = light.light;
}

/* Neighbours on a curve through the square that ways are drawn from (Morton
 * 1966) go nearly the same way. */
static uint32_t way_place(uint64_t key, uint32_t index)
{
    const struct draws draws = { key, index };
    uint32_t place = 0;
    double u[2];
    draw_pair(&draws, GATHER_DIRECTION, u);
    for (int bit = 1; bit <= 8; bit++)
        for (int i = 0; i < 2; i++)
            place = place << 1 | ((uint32_t)ldexp(u[i], bit) & 1);
    return place;
}

struct way_order {
    uint32_t place, sample;
};

static int way_compare(const void *a, const void *b)
{
    const struct way_order *x = a, *y = b;
    return x->place != y->place
               ? (x->place > y->place) - (x->place < y->place)
               : (x->sample > y->sample) - (x->sample < y->sample);
}

/* Of each part of the set, which begins at `first`. */
static void ways_order(struct indirect_mesh *mesh, uint32_t first,
                       struct way_order *sorted)
{
    uint32_t count = (uint32_t)mesh->samples;
    for (uint32_t i = 0; i < count; i++)
        sorted[i] =
            (struct way_order){ way_place(mesh->gather.lamps->seed, first + i),
                                i };
    qsort(sorted, count, sizeof *sorted, way_compare);
    for (uint32_t i = 0; i < count; i++)
        mesh->order[first + i] = sorted[i].sample;
}

/* All mesh points look along the same ways: they are drawn once. */
static void mesh_ways(struct indirect_mesh *mesh)
{
    for (mesh->set = 1; mesh->set < (uint32_t)mesh->samples;)
        mesh->set *= 2;
    uint32_t count = 7 * mesh->set + (uint32_t)mesh->samples;
    if (count > WAYS_MOST)
        return;
    mesh->ways = memory_new(count * sizeof *mesh->ways);
    for (uint32_t i = 0; i < count; i++)
        mesh->ways[i] = way_drawn(mesh->gather.lamps->seed, i);
    mesh->order = memory_new(count * sizeof *mesh->order);
    struct way_order *sorted =
        memory_new((size_t)mesh->samples * sizeof *sorted);
    for (uint32_t part = 0; part < 8; part++)
        ways_order(mesh, part * mesh->set, sorted);
    memory_free(sorted);
}

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
        .onward = options->onward,
        .tone = options->tone,
    };
    mesh->samples = options->samples;
    mesh->gather.wide = 2 / sqrt(fmax(options->samples, 1));
    if (options->bright && options->bright->count > 0)
        mesh->bright = options->bright;
    mesh->near = options->near;
    mesh->near_ways = near_field_ways(&mesh->gather, mesh->near);
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
        .fill = fill_gather,
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
    mesh_ways(mesh);
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
        memory_free(mesh->ways);
        memory_free(mesh->order);
        memory_free(mesh->near_ways);
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

static struct indirect_light blend_light(const struct mesh_blend *blend)
{
    struct indirect_light sum = indirect_light_none;
    for (int i = 0; i < blend->count; i++)
        indirect_light_mix(&sum, blend->at[i].payload,
                           (float)blend->at[i].weight);
    return sum;
}

/* A point that is the place itself sees by itself what is close. */
struct indirect_share indirect_mesh_around(const struct indirect_mesh *mesh,
                                           struct worker *worker,
                                           const struct receiver *receiver,
                                           int rays,
                                           struct indirect_light *light)
{
    struct mesh_blend blend;
    point_mesh_blend(&mesh->points, worker, receiver, &blend);
    *light = blend_light(&blend);
    return blend.here ? indirect_light_share(light, receiver->side)
                      : near_field_share(mesh, worker, receiver, rays, light);
}

struct indirect_share indirect_mesh_light(const struct indirect_mesh *mesh,
                                          struct worker *worker,
                                          const struct receiver *receiver)
{
    const struct gather *gather = &mesh->gather;
    if (indirect_mesh_leaves(mesh, receiver)) {
        struct indirect_share share = gather->around;
        gather_closes(gather, worker, receiver, &share);
        return share;
    }
    struct indirect_light light;
    if (!receiver->pixel) {
        struct mesh_blend blend;
        point_mesh_blend(&mesh->points, worker, receiver, &blend);
        light = blend_light(&blend);
        return indirect_light_share(&light, receiver->normal);
    }
    struct indirect_share share = indirect_mesh_around(
        mesh, worker, receiver, mesh->near / NEAR_LONE_PART, &light);
    if (vec3_dot(receiver->normal, receiver->side) < indirect_pixels_flat)
        share = indirect_light_share(&light, receiver->normal);
    return share;
}

bool indirect_mesh_nearest(const struct indirect_mesh *mesh,
                           struct worker *worker,
                           const struct receiver *receiver, vec3 jitter,
                           struct indirect_share *share)
{
    const struct indirect_light *nearest =
        point_mesh_nearest(&mesh->points, worker, receiver, jitter);
    if (nearest)
        *share = indirect_light_share(nearest, receiver->normal);
    return nearest;
}
