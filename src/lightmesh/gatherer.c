/* A mesh point that gathers: see gatherer.h. */
#include "lightmesh/gatherer.h"

#include "base/draw.h"
#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/gather_virtual.h"
#include "lightmesh/near_glow.h"
#include "lightmesh/tuning.h"

/* A mesh point that gathers. */
struct gatherer {
    const struct indirect_mesh *mesh;
    struct worker *worker;
    const struct mesh_site *site;
    uint32_t wall_share;  /* of ways into a wall one of so many is gone */
    uint32_t count, even; /* rays, and how many of them everywhere alike; the
                           * others go to bright places */
    uint32_t picks;       /* rays to what glows */
    struct aim aim;
};

/* What one ray brought, with the density of its way; 0: it was not sent. */
struct brought {
    rgb light;
    double open, density;
    rgb dull; /* of that what isn't picked: what glows is no edge */
};

/* Rays that are waiting. */
struct waiting {
    struct gather_rays rays;
    double counts[RAY_LANES]; /* how much each counts */
    uint32_t cell[RAY_LANES]; /* which of the part's ways each is */
    struct brought *brought;  /* of each of these, to be looked at before it
                               * counts; NULL: it counts at once */
};

/* What came from the only wall near is kept apart: it lights nothing, and is
 * rougher. */
struct gathered {
    struct indirect_light light, wall;
    double all; /* what way_cells.h compares differences with */
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
    double even = (double)gatherer->even / gatherer->count / (4 * WARP_PI);
    if (wall)
        return even / gatherer->wall_share;
    return even + aim_density(&gatherer->aim, way) / gatherer->count;
}

static vec3 gatherer_way(const struct gatherer *gatherer,
                         const struct draws *draws)
{
    const struct mesh_site *site = gatherer->site;
    if (!site->lone && gatherer->mesh->ways.ways)
        return gatherer->mesh->ways.ways[draws->index];
    vec3 way = gather_way(draws->key, draws->index);
    double behind = site->lone ? vec3_dot(way, site->normal) : 0;
    return behind < 0 ? vec3_along(way, site->normal, -2 * behind) : way;
}

/* Which part of a set a mesh point has, */
static uint32_t gatherer_part(const struct gatherer *gatherer)
{
    return (uint32_t)(gatherer->site->dither * GATHER_PARTS);
}

/* and where it begins among the ways. */
static uint32_t gatherer_first(const struct gatherer *gatherer)
{
    return gatherer_part(gatherer) * gatherer->mesh->ways.set;
}

static double brought_weight(const struct brought *brought)
{
    return rgb_brightness(brought->light) / brought->density;
}

static void gathered_add(struct gathered *sum, const struct gatherer *gatherer,
                         vec3 way, const struct brought *brought, double counts)
{
    bool wall = vec3_dot(way, gatherer->site->wall) > 0;
    indirect_light_add(wall ? &sum->wall : &sum->light, way, brought->light,
                       brought->open, brought->density / counts);
    sum->all += counts * brought_weight(brought);
}

/* How much of that glow isn't left to places close to it. */
static double gatherer_glow(const struct gatherer *gatherer,
                            const struct leaf *leaf, double distance)
{
    const struct near_glow *near =
        gatherer->site->lone ? NULL : gatherer->mesh->near_glow;
    return 1 - near_glow_share(near, leaf, distance);
}

/* One gather ray. What glows counts by how likely it is to be found so. */
static struct brought gatherer_look(const struct gatherer *gatherer,
                                    struct waiting *waiting, unsigned i)
{
    const struct gather *gather = &gatherer->mesh->gather;
    const struct ray ray = rays_at(&waiting->rays.rays, (int)i);
    double density = gatherer_density(gatherer, ray.direction);
    const struct gathered_ray *found =
        gather_rays_follow(gather, gatherer->worker, &waiting->rays, i);
    double picks = density * gatherer->count / gatherer->picks;
    double left = rgb_peak(found->glow) > 0
                      ? gatherer_glow(gatherer, found->at.leaf, found->at.t)
                      : 1;
    rgb light = gather_balanced(gather, &ray, picks, left, found);
    rgb dull = emitters_any(gather->emitters)
                   ? rgb_sub(found->light, found->glow)
                   : light;
    return (struct brought){ light, found->open, density, dull };
}

static void gatherer_flush(const struct gatherer *gatherer,
                           struct waiting *waiting, struct gathered *sum)
{
    struct gather_rays *rays = &waiting->rays;
    gather_rays_trace(&gatherer->mesh->gather, gatherer->worker, rays);
    for (unsigned i = 0; i < rays->count; i++) {
        struct brought brought = gatherer_look(gatherer, waiting, i);
        if (waiting->brought)
            waiting->brought[waiting->cell[i]] = brought;
        else
            gathered_add(sum, gatherer, rays_direction(&rays->rays, (int)i),
                         &brought, waiting->counts[i]);
    }
    rays->count = 0;
}

static void gatherer_send(const struct gatherer *gatherer,
                          const struct draws *draws, vec3 way, double counts,
                          struct waiting *waiting, struct gathered *sum)
{
    waiting->counts[waiting->rays.count] = counts;
    waiting->cell[waiting->rays.count] =
        draws->index - gatherer_first(gatherer);
    gather_rays_add(&waiting->rays, draws, gatherer->site->place, way);
    if (waiting->rays.count == RAY_LANES)
        gatherer_flush(gatherer, waiting, sum);
}

static struct draws gatherer_draws(const struct gatherer *gatherer,
                                   uint32_t sample)
{
    const struct mesh_site *site = gatherer->site;
    if (site->lone)
        return (struct draws){ site->key, sample };
    return (struct draws){ gatherer->mesh->gather.lamps->seed,
                           gatherer_first(gatherer) + sample };
}

/* The one to be sent after `i` others. */
static uint32_t gatherer_sample(const struct gatherer *gatherer, uint32_t i)
{
    const struct gather_ways *ways = &gatherer->mesh->ways;
    return gatherer->site->lone || !ways->order
               ? i
               : ways->order[gatherer_first(gatherer) + i];
}

/* The sum of what is sent everywhere. */
static void gatherer_even(const struct gatherer *gatherer,
                          struct waiting *waiting, struct gathered *sum)
{
    uint32_t samples = gatherer->site->lone ? gatherer->even
                                            : (uint32_t)gatherer->mesh->samples;
    uint32_t wall_end = gatherer->even / gatherer->wall_share;
    for (uint32_t i = 0; i < samples && !worker_stopped(gatherer->worker);
         i++) {
        uint32_t sample = gatherer_sample(gatherer, i);
        if (sample >= gatherer->even)
            continue;
        struct draws draws = gatherer_draws(gatherer, sample);
        vec3 way = gatherer_way(gatherer, &draws);
        bool wall = vec3_dot(way, gatherer->site->wall) > 0;
        if (!wall || sample < wall_end)
            gatherer_send(gatherer, &draws, way, 1, waiting, sum);
    }
    gatherer_flush(gatherer, waiting, sum);
}

/* The ways that other parts have in a cell, each of which counts as its own way
 * does: by so much. */
static void gatherer_look_closely(const struct gatherer *gatherer,
                                  uint32_t cell, double counts,
                                  struct waiting *waiting, struct gathered *sum)
{
    const struct indirect_mesh *mesh = gatherer->mesh;
    const struct part_cells *part = &mesh->cells.part[gatherer_part(gatherer)];
    for (uint32_t i = part->first[cell]; i < part->first[cell + 1]; i++) {
        struct draws draws = { mesh->gather.lamps->seed, part->ways[i] };
        if (draws.index != gatherer_first(gatherer) + cell)
            gatherer_send(gatherer, &draws, mesh->ways.ways[draws.index],
                          counts, waiting, sum);
    }
}

/* Adds up what the ways of a part brought; where there is an edge, with what
 * the others do. Nothing is worth a second look before the only wall near. */
static void gatherer_settle(const struct gatherer *gatherer,
                            const struct brought *brought,
                            struct waiting *waiting, struct gathered *sum)
{
    const struct indirect_mesh *mesh = gatherer->mesh;
    const uint32_t count = mesh->cells.count, part = gatherer_part(gatherer);
    const uint32_t *first = mesh->cells.part[part].first;
    const vec3 *own = mesh->ways.ways + gatherer_first(gatherer);
    double weight[WAY_CELLS_MOST], all = sum->all;
    bool edge[WAY_CELLS_MOST];
    for (uint32_t i = 0; i < count; i++) {
        bool wall = vec3_dot(own[i], gatherer->site->wall) > 0;
        bool sent = brought[i].density > 0;
        all += sent ? brought_weight(&brought[i]) : 0;
        weight[i] = sent && !wall
                        ? rgb_brightness(brought[i].dull) / brought[i].density
                        : (double)NAN;
    }
    way_cells_edges(&mesh->cells, part, weight,
                    mesh->edge * all / gatherer->count, edge);
    for (uint32_t i = 0; i < count && !worker_stopped(gatherer->worker); i++) {
        double counts = edge[i] ? 1.0 / (first[i + 1] - first[i]) : 1;
        if (brought[i].density > 0)
            gathered_add(sum, gatherer, own[i], &brought[i], counts);
        if (edge[i])
            gatherer_look_closely(gatherer, i, counts, waiting, sum);
    }
    gatherer_flush(gatherer, waiting, sum);
}

/* The same as gatherer_even, with a closer look at edges. */
static void gatherer_cells(const struct gatherer *gatherer,
                           struct waiting *waiting, struct gathered *sum)
{
    struct brought brought[WAY_CELLS_MOST];
    for (uint32_t i = 0; i < gatherer->mesh->cells.count; i++)
        brought[i].density = 0;
    waiting->brought = brought;
    gatherer_even(gatherer, waiting, sum);
    waiting->brought = NULL;
    gatherer_settle(gatherer, brought, waiting, sum);
}

/* And of what is sent to one bright place. What is worth more rays sends the
 * same ones and others: a picture's light changes by little when another finds
 * the place a little brighter. */
static void gatherer_aim_at(const struct gatherer *gatherer,
                            const struct aim_disc *disc,
                            struct waiting *waiting, struct gathered *sum)
{
    const uint32_t part = gatherer_part(gatherer);
    struct draws draws = {
        random_key(gatherer->mesh->gather.lamps->seed, disc->key), 0
    };
    for (uint32_t i = 0; i < disc->rays && !worker_stopped(gatherer->worker);
         i++, draws.index++) {
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
        gather_part_shift(part, u);
        vec3 way = aim_way(&gatherer->aim, disc, u);
        if (!(vec3_dot(way, gatherer->site->wall) > 0))
            gatherer_send(gatherer, &draws, way, fmin(disc->rays - i, 1),
                          waiting, sum);
    }
}

static void gatherer_aim(const struct gatherer *gatherer,
                         struct waiting *waiting, struct gathered *sum)
{
    for (int i = 0; i < gatherer->aim.count; i++)
        gatherer_aim_at(gatherer, &gatherer->aim.disc[i], waiting, sum);
    gatherer_flush(gatherer, waiting, sum);
}

/* Those of all parts are a net, too. */
static struct draws gatherer_pick_draws(const struct gatherer *gatherer,
                                        uint32_t pick)
{
    if (gatherer->site->lone)
        return (struct draws){ gatherer->site->key, pick };
    uint32_t first = gatherer_part(gatherer) * gatherer->picks;
    return (struct draws){ gatherer->mesh->gather.lamps->seed, first + pick };
}

/* The same for places on what glows. */
static void gatherer_pick(const struct gatherer *gatherer,
                          struct indirect_light *light)
{
    const struct gather *gather = &gatherer->mesh->gather;
    struct gathered_glow found[RAY_LANES];
    struct draws draws[RAY_LANES];
    uint32_t next = 0;
    while (next < gatherer->picks && !worker_stopped(gatherer->worker)) {
        unsigned count = 0;
        while (next < gatherer->picks && count < RAY_LANES)
            draws[count++] = gatherer_pick_draws(gatherer, next++);
        count = gather_pick(gather, gatherer->worker, gatherer->site->place,
                            draws, count, found);
        for (unsigned i = 0; i < count; i++)
            indirect_light_add(
                light, found[i].direction,
                rgb_scale(found[i].light, gatherer_glow(gatherer, found[i].leaf,
                                                        found[i].distance)),
                0,
                found[i].density * gatherer->picks / gatherer->count +
                    gatherer_density(gatherer, found[i].direction));
    }
}

/* What virtual lights bring. */
static void gatherer_virtual(const struct gatherer *gatherer,
                             struct gathered *sum)
{
    const struct gather *gather = &gatherer->mesh->gather;
    struct gathered_glow found[VIRTUAL_PICKS_MOST];
    unsigned part = gatherer->site->lone
                        ? (unsigned)(gatherer->site->key % GATHER_PARTS)
                        : gatherer_part(gatherer);
    unsigned count = gather_virtual(gather, gatherer->worker,
                                    gatherer->site->place, part, found);
    for (unsigned i = 0; i < count; i++) {
        const struct brought brought = { .light = found[i].light,
                                         .density = found[i].density };
        gathered_add(sum, gatherer, found[i].direction, &brought,
                     gatherer->count);
    }
}

static struct gathered gatherer_mean(const struct gatherer *gatherer)
{
    struct gathered sum = { indirect_light_none, indirect_light_none, 0 };
    struct waiting waiting; /* the rest of it isn't read before it is set */
    waiting.rays.count = 0;
    waiting.brought = NULL;
    bool cells =
        !gatherer->site->lone && gatherer->even == gatherer->mesh->cells.count;
    if (gatherer->mesh->gather.virtual_lights)
        gatherer_virtual(gatherer, &sum);
    gatherer_aim(gatherer, &waiting, &sum);
    (cells ? gatherer_cells : gatherer_even)(gatherer, &waiting, &sum);
    if (emitters_any(gatherer->mesh->gather.emitters))
        gatherer_pick(gatherer, &sum.light);
    indirect_light_scale(&sum.light, 1 / (float)gatherer->count);
    indirect_light_scale(&sum.wall, 1 / (float)gatherer->count);
    return sum;
}

static double lone_samples(const struct indirect_mesh *mesh, double worth)
{
    double whole = fmin(worth / gather_worth_whole, 1);
    return ceil(whole * whole * mesh->lone_samples);
}

uint32_t gatherer_everywhere(uint32_t samples, bool aims)
{
    return aims ? samples - samples / BRIGHT_PART : samples;
}

void gatherer_fill(const void *context, struct worker *worker,
                   const struct mesh_site *site, void *payload)
{
    const struct indirect_mesh *mesh = context;
    struct gatherer gatherer; /* of `aim` no more is set than is read */
    gatherer.mesh = mesh;
    gatherer.worker = worker;
    gatherer.site = site;
    gatherer.count = (uint32_t)mesh->samples;
    if (site->lone)
        gatherer.count =
            (uint32_t)fmin(gatherer.count, lone_samples(mesh, site->worth));
    gatherer.wall_share = gatherer.count % WALL_PART > 0 ? 1 : WALL_PART;
    gatherer.even = gatherer.count;
    gatherer.aim.count = 0;
    if (mesh->bright && !site->lone) {
        uint32_t even = gatherer_everywhere(gatherer.count, true);
        aim_take(&gatherer.aim, mesh->bright, site->place,
                 gatherer.count - even);
        if (gatherer.aim.count > 0)
            gatherer.even = even;
    }
    gatherer.picks = (gatherer.count + PICK_PART - 1) / PICK_PART;
    if (!site->lone && gatherer.picks < (uint32_t)mesh->glow_picks)
        gatherer.picks = (uint32_t)mesh->glow_picks;
    struct gathered light = gatherer_mean(&gatherer);
    indirect_light_mix(&light.light, &light.wall, 1);
    *(struct indirect_light *)payload = light.light;
}
