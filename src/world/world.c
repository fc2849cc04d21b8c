/* The world: see world.h. What is bounded is found by Embree (geometry.c), the
 * rest, planes most of all, by trying one after the other. */
#include "world/world.h"

#include "base/memory.h"
#include "world/describe.h"
#include "world/geometry.h"
#include "world/packet.h"
#include "world/shaft_tree.h"

enum { PACKET_LEAST = 4 }; /* rays */

/* POV-Ray sees nothing farther than this. */
static const double world_limit = 1e7;

struct world {
    struct arena *arena;
    struct flat flat;   /* its solids: the unbounded ones, shapes first */
    size_t shape_count; /* of flat.solids */
    bool bounded;       /* there is something in the geometry */
    bool boxed;         /* rays are clipped by boxes */
    struct geometry geometry;
    struct shaft_tree *shafts; /* if a light has an area */
};

/* Single shapes are quick and shorten the ray for what comes after. */
static void sort_unbounded(struct world *world)
{
    struct solid_list *list = &world->flat.solids;
    for (size_t i = 0; i < list->count; i++) {
        struct solid *solid = list->items[i];
        if (!solid->simple)
            continue;
        list->items[i] = list->items[world->shape_count];
        list->items[world->shape_count++] = solid;
    }
}

static bool any_area(const struct light_list *lights)
{
    for (size_t i = 0; i < lights->count; i++)
        if (lights->items[i].area)
            return true;
    return false;
}

struct world *world_new(const struct scene *scene, unsigned threads,
                        double camera_rays, struct diag *diag)
{
    struct world *world = memory_new(sizeof *world);
    world->arena = arena_new(0);
    world->flat.arena = world->arena;
    world->flat.diag = diag;
    if (!flatten_scene(&world->flat, scene) ||
        !geometry_build(&world->geometry, &world->flat, threads, camera_rays,
                        diag)) {
        world_free(world);
        return NULL;
    }
    sort_unbounded(world);
    world->bounded = !box3_is_empty(world->geometry.bounds);
    world->boxed =
        world->bounded || world->shape_count < world->flat.solids.count;
    if (any_area(&world->flat.lights))
        world->shafts = shaft_tree_new(&world->flat, &world->geometry.solids);
    return world;
}

void world_free(struct world *world)
{
    if (!world)
        return;
    geometry_free(&world->geometry, &world->flat);
    arena_free(world->arena);
    memory_free(world);
}

const struct light *world_lights(const struct world *world, size_t *count)
{
    *count = world->flat.lights.count;
    return world->flat.lights.items;
}

void world_solo(struct world *world, size_t light)
{
    for (size_t i = 0; i < world->flat.lights.count; i++)
        if (i != light)
            world->flat.lights.items[i].colour = rgb_grey(0);
}

bool world_is_opaque(const struct world *world)
{
    return !world->flat.translucent;
}

static bool trace_unbounded(const struct world *world, struct query *query,
                            size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        if (query_solid(query, world->flat.solids.items[i]))
            return true;
    return false;
}

/* Whether all six numbers are finite: then 0 times each is 0. */
static inline bool ray_is_finite(const struct ray *ray)
{
    vec3 o = ray->origin, d = ray->direction;
    return (o.x + o.y + o.z) * 0 + (d.x + d.y + d.z) * 0 == 0;
}

/* Into *query all that both kinds of question have in common. Rays that are
 * not rays meet nothing: false. */
static inline bool query_begin(const struct world *world, struct query *query,
                               const struct ray *ray, double tmin, double tmax)
{
    vec3 d = ray->direction;
    if (!ray_is_finite(ray) || !(vec3_dot(d, d) > 0))
        return false;
    query->ray = *ray;
    if (world->boxed)
        query->slabs = slabs_of(ray);
    query->tmin = tmin;
    query->tmax = tmax;
    query->spread = 0;
    query->packet = NULL;
    query->leaf = NULL;
    query->rough = false;
    query->blocked = false;
    query->recent_count = 0;
    return tmin < tmax;
}

static void describe_nearest(struct query *query, struct intersection *out)
{
    query_finish(query);
    describe_hit(&query->ray, query->leaf, &query->hit, out);
}

/* Finds query->leaf, NULL if there is none. */
static void trace_nearest(const struct world *world, struct query *query)
{
    trace_unbounded(world, query, 0, world->shape_count);
    if (world->bounded)
        geometry_trace(&world->geometry, query);
    trace_unbounded(world, query, world->shape_count, world->flat.solids.count);
}

bool world_closest(const struct world *world, const struct ray *ray,
                   double tmin, enum ray_kind kind, struct intersection *out)
{
    return world_within(world, ray, tmin, world_limit, kind, out);
}

/* Looks at what is infinite. Returns whether no ray is left open. */
static bool look_unbounded(const struct world *world, struct packet *packet,
                           size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        if (packet_look(packet, world->flat.solids.items[i], packet->open))
            return true;
    return false;
}

/* Looks at everything. */
static void packet_trace(const struct world *world, struct packet *packet)
{
    size_t shapes = world->shape_count, count = world->flat.solids.count;
    if (look_unbounded(world, packet, 0, shapes))
        return;
    if (world->bounded)
        geometry_look(&world->geometry, packet);
    look_unbounded(world, packet, shapes, count);
}

/* Rays that are no packet: too few, or on their way to all sides among many
 * things, where each meets others [a torus of spheres: .84 of the time, a
 * desk 1]. */
static bool rays_part(const struct world *world, unsigned count,
                      enum ray_kind kind)
{
    return count < PACKET_LEAST || (kind == RAY_GATHER && world->bounded &&
                                    !world->geometry.few.solids);
}

/* One after the other. */
static void closest_each(const struct world *world, const struct rays *rays,
                         const struct rays_span *span, unsigned count,
                         enum ray_kind kind, struct world_hit *out)
{
    struct query query;
    query.occlusion = false;
    query.kind = kind;
    for (unsigned i = 0; i < count; i++) {
        const struct ray ray = rays_at(rays, (int)i);
        out[i].leaf = NULL;
        if (!query_begin(world, &query, &ray, span->near[i],
                         lesser(span->far[i], world_limit)))
            continue;
        trace_nearest(world, &query);
        out[i].leaf = query.leaf;
        out[i].hit = query.hit;
    }
}

void world_closest_many(const struct world *world, const struct rays *rays,
                        const struct rays_span *span, unsigned count,
                        enum ray_kind kind, struct world_hit *out)
{
    struct packet packet;
    const struct nearest asked = { rays, span, kind, (1u << count) - 1, out };
    if (rays_part(world, count, kind)) {
        closest_each(world, rays, span, count, kind, out);
        return;
    }
    packet_to_nearest(&packet, &asked, world_limit, world->boxed);
    packet_trace(world, &packet);
    packet_tell(&packet);
}

bool world_within(const struct world *world, const struct ray *ray, double tmin,
                  double tmax, enum ray_kind kind, struct intersection *out)
{
    const struct glimpse exact = { tmin, tmax, 0 };
    return world_glimpse(world, ray, exact, kind, out);
}

bool world_glimpse(const struct world *world, const struct ray *ray,
                   struct glimpse glimpse, enum ray_kind kind,
                   struct intersection *out)
{
    struct query query;
    query.occlusion = false;
    query.kind = kind;
    if (!query_begin(world, &query, ray, glimpse.tmin,
                     lesser(glimpse.tmax, world_limit)))
        return false;
    query.spread = glimpse.spread;
    trace_nearest(world, &query);
    if (!query.leaf)
        return false;
    describe_nearest(&query, out);
    return true;
}

static bool occlusion_begin(const struct world *world, struct query *query,
                            const struct occlusion *occlusion)
{
    query->occlusion = true;
    query->light = occlusion->light;
    query->filter = occlusion->filter;
    query->context = occlusion->context;
    bool begun = query_begin(world, query, occlusion->ray, occlusion->tmin,
                             lesser(occlusion->tmax, world_limit));
    query->spread = occlusion->spread;
    return begun;
}

bool world_occluded(const struct world *world,
                    const struct occlusion *occlusion)
{
    struct query query;
    size_t count = world->flat.solids.count;
    if (!occlusion_begin(world, &query, occlusion))
        return false;
    if (trace_unbounded(world, &query, 0, world->shape_count))
        return true;
    if (world->bounded)
        geometry_trace(&world->geometry, &query);
    return query.blocked ||
           trace_unbounded(world, &query, world->shape_count, count);
}

static bool occluded_one(const struct world *world,
                         const struct occlusions *asked, unsigned i,
                         const struct occlusion *one)
{
    if (!asked->shaft)
        return world_occluded(world, one);
    const double place[2] = { asked->place[0][i], asked->place[1][i] };
    return world_occluded_in(world, asked->shaft, place, one);
}

/* Rays that are too few to be a packet. */
static unsigned occluded_each(const struct world *world,
                              const struct occlusions *asked, unsigned lanes)
{
    unsigned blocked = 0;
    for (; lanes; lanes &= lanes - 1) {
        int i = __builtin_ctz(lanes);
        const struct ray ray = rays_at(&asked->rays, i);
        const struct occlusion one = { .ray = &ray,
                                       .tmin = asked->span.near[i],
                                       .tmax = asked->span.far[i],
                                       .light = asked->light };
        if (occluded_one(world, asked, (unsigned)i, &one))
            blocked |= 1u << i;
    }
    return blocked;
}

struct occluded world_occluded_many(const struct world *world,
                                    const struct occlusions *asked,
                                    unsigned lanes)
{
    bool opaque = world_is_opaque(world);
    struct packet packet;
    if (__builtin_popcount(lanes) < PACKET_LEAST)
        return opaque
                   ? (struct occluded){ occluded_each(world, asked, lanes), 0 }
                   : (struct occluded){ 0, lanes };
    bool known = asked->shaft && !asked->shaft->crowded;
    packet.opaque = opaque;
    packet_to_lamp(&packet, asked, lanes, world_limit, known || world->boxed);
    unsigned started = packet.open;
    if (known)
        shaft_look(asked->shaft, asked->place, &packet);
    else
        packet_trace(world, &packet);
    return (struct occluded){ started & ~packet.open & ~packet.panes,
                              packet.panes };
}

void world_shaft(const struct world *world, const struct shaft_rays *rays,
                 struct shaft *shaft)
{
    shaft->crowded = true;
    if (world->shafts)
        shaft_find(world->shafts, rays, shaft);
}

double world_blur(const struct world *world, const struct shaft_rays *rays,
                  double enough)
{
    return world->shafts ? shaft_blur(world->shafts, rays, enough) : 0;
}

bool world_occluded_in(const struct world *world, const struct shaft *shaft,
                       const double place[2], const struct occlusion *occlusion)
{
    struct query query;
    if (shaft->crowded)
        return world_occluded(world, occlusion);
    if (!occlusion_begin(world, &query, occlusion))
        return false;
    for (int i = 0; i < shaft->count; i++)
        if (shaft_shades(&shaft->at[i], place) &&
            query_solid(&query, shaft->at[i].solid))
            return true;
    return false;
}

void world_containing(const struct world *world, vec3 point,
                      void (*visit)(void *context, const struct leaf *leaf),
                      void *context)
{
    const struct container_list *list = &world->flat.containers;
    for (size_t i = 0; i < list->count; i++)
        solid_containing(list->items[i], point, visit, context);
}

static bool boxes_meet(struct box3 a, struct box3 b)
{
    return !box3_is_empty(box3_intersection(a, b));
}

bool world_contains_alike(const struct world *world, struct box3 box)
{
    const struct container_list *list = &world->flat.containers;
    for (size_t i = 0; i < list->count; i++) {
        const struct solid *solid = list->items[i];
        bool bounded = box3_is_finite(solid->surface);
        bool away = !boxes_meet(*solid->region, box) ||
                    (bounded && !boxes_meet(solid->surface, box));
        if (!away && !solid_surrounds(solid, box))
            return false;
    }
    return true;
}

static void visit_solids(const struct solid_list *list,
                         void (*visit)(void *context,
                                       const struct solid *solid),
                         void *context)
{
    for (size_t i = 0; i < list->count; i++)
        visit(context, list->items[i]);
}

void world_visit(const struct world *world,
                 void (*solid)(void *context, const struct solid *solid),
                 void (*mesh)(void *context, const struct leaf *leaf),
                 void *context)
{
    visit_solids(&world->flat.solids, solid, context);
    visit_solids(&world->geometry.solids, solid, context);
    for (size_t i = 0; i < world->flat.meshes.count; i++)
        mesh(context, world->flat.meshes.items[i]);
}

size_t world_leaf_count(const struct world *world)
{
    return world->flat.leaf_count;
}

size_t world_triangle_count(const struct world *world)
{
    return world->flat.triangle_count;
}

struct box3 world_bounds(const struct world *world)
{
    return world->geometry.bounds;
}

double world_pane(const struct world *world, int light, const struct ray *ray,
                  double tmin, double tmax)
{
    const struct light_list *lights = &world->flat.lights;
    struct query query;
    if (light < 0 || !lights->items[light].pane)
        return tmax;
    if (!query_begin(world, &query, ray, tmin, tmax))
        return -1;
    query.slabs = slabs_of(ray);
    query.occlusion = false;
    query.kind = RAY_REFLECTION;
    query_solid(&query, lights->items[light].pane);
    return query.leaf ? query.tmax : -1;
}

unsigned world_targets(const struct world *world)
{
    return world->flat.targets;
}
