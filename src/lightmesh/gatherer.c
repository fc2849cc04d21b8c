/* A mesh point that gathers: see gatherer.h. */
#include "lightmesh/gatherer.h"

#include "base/draw.h"
#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/tuning.h"

/* A mesh point that gathers. */
struct gatherer {
    const struct indirect_mesh *mesh;
    struct worker *worker;
    const struct mesh_site *site;
    uint32_t wall_share;  /* of ways into a wall one of so many is gone */
    uint32_t count, even; /* rays, and how many of them everywhere alike; the
                           * others go to bright places */
    struct aim aim;
};

/* Rays that are waiting. */
struct waiting {
    struct gather_rays rays;
    double counts[RAY_LANES]; /* how much each counts */
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

/* One gather ray. What glows counts by how likely it is to be found so. */
static void gatherer_look(const struct gatherer *gatherer,
                          const struct waiting *waiting, unsigned i,
                          struct gathered *sum)
{
    const struct gather *gather = &gatherer->mesh->gather;
    const struct ray ray = rays_at(&waiting->rays.rays, (int)i);
    double density = gatherer_density(gatherer, ray.direction);
    bool wall = vec3_dot(ray.direction, gatherer->site->wall) > 0;
    struct gathered_ray found;
    gather_rays_follow(gather, gatherer->worker, &waiting->rays, i, &found);
    indirect_light_add(wall ? &sum->wall : &sum->light, ray.direction,
                       gather_balanced(gather, &ray, density, &found),
                       found.open, density / waiting->counts[i]);
}

static void gatherer_flush(const struct gatherer *gatherer,
                           struct waiting *waiting, struct gathered *sum)
{
    struct gather_rays *rays = &waiting->rays;
    gather_rays_trace(&gatherer->mesh->gather, gatherer->worker,
                      (double)INFINITY, rays);
    for (unsigned i = 0; i < rays->count; i++)
        gatherer_look(gatherer, waiting, i, sum);
    rays->count = 0;
}

static void gatherer_send(const struct gatherer *gatherer,
                          const struct draws *draws, vec3 way, double counts,
                          struct waiting *waiting, struct gathered *sum)
{
    waiting->counts[waiting->rays.count] = counts;
    gather_rays_add(&waiting->rays, draws, gatherer->site->place, way);
    if (waiting->rays.count == RAY_LANES)
        gatherer_flush(gatherer, waiting, sum);
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

/* And of what is sent to one bright place. What is worth more rays sends the
 * same ones and others: a picture's light changes by little when another finds
 * the place a little brighter. */
static void gatherer_aim_at(const struct gatherer *gatherer,
                            const struct aim_disc *disc,
                            struct waiting *waiting, struct gathered *sum)
{
    struct draws draws = { random_key(gatherer->mesh->gather.lamps->seed,
                                      disc->key),
                           gatherer_part(gatherer) * AIM_RAYS_MOST };
    for (uint32_t i = 0; i < disc->rays && !worker_stopped(gatherer->worker);
         i++, draws.index++) {
        double u[2];
        draw_pair(&draws, GATHER_DIRECTION, u);
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

static struct gathered gatherer_mean(const struct gatherer *gatherer)
{
    struct gathered sum = { indirect_light_none, indirect_light_none };
    uint32_t count = gatherer->count;
    struct waiting waiting = { .rays.count = 0 };
    gatherer_even(gatherer, &waiting, &sum);
    gatherer_aim(gatherer, &waiting, &sum);
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

void gatherer_fill(const void *context, struct worker *worker,
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
    gatherer.even = gatherer.count;
    gatherer.aim.count = 0;
    if (mesh->bright && !site->lone) {
        uint32_t aimed = gatherer.count / BRIGHT_PART;
        aim_take(&gatherer.aim, mesh->bright, site->place, aimed);
        if (gatherer.aim.count > 0)
            gatherer.even -= aimed;
    }
    struct gathered light = gatherer_mean(&gatherer);
    indirect_light_mix(&light.light, &light.wall, 1);
    *(struct indirect_light *)payload = light.light;
}
