/* Points that are computed when they are asked for: see point_mesh.h. */
#include "lightmesh/point_mesh.h"

#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"

/* What stands around points is kept apart from what they know: many are found
 * to be hidden, and then need know nothing. */
void point_mesh_start(struct point_mesh *mesh, size_t bytes)
{
    size_t payload = mesh->payload_size + sizeof(void *),
           around = sizeof(struct obstacles) + sizeof(void *);
    size_t share = bytes / (payload + 2 * around);
    mesh->around = table_new(sizeof(struct obstacles), 2 * share * around);
    mesh->table = table_new(mesh->payload_size, share * payload);
    mesh->work = memory_new(sizeof *mesh->work);
}

void point_mesh_free(struct point_mesh *mesh)
{
    table_free(mesh->around);
    table_free(mesh->table);
    memory_free(mesh->work);
}

static double table_crowding(const struct table *table)
{
    return table_wanted(table) / (double)table_capacity(table);
}

double point_mesh_crowding(const struct point_mesh *mesh)
{
    return fmax(table_crowding(mesh->table), table_crowding(mesh->around));
}

size_t point_mesh_bytes(const struct point_mesh *mesh)
{
    return table_bytes(mesh->table) + table_bytes(mesh->around);
}

/* Three bits that differ between the corners of any cell, and of which the
 * upper two differ between the corners of any side of it (linear over GF(2));
 * within the eighth a number of the block of eight. */
static double site_dither(const struct lattice_point *point)
{
    unsigned i = (unsigned)point->at[0] & 1, j = (unsigned)point->at[1] & 1,
             k = (unsigned)point->at[2] & 1;
    unsigned eighth = (i ^ j) << 2 | (j ^ k) << 1 | (i ^ j ^ k);
    struct lattice_point block = { point->level,
                                   { point->at[0] >> 1, point->at[1] >> 1,
                                     point->at[2] >> 1 } };
    return (eighth + random_unit(lattice_key(&block))) / 8;
}

/* The name under which a point's payload is kept: that of all levels if they
 * are mixed. What is around a point is looked for as far as its level says. */
static struct lattice_point point_shared(const struct point_mesh *mesh,
                                         const struct lattice_point *point)
{
    if (mesh->refinement.levels == 0)
        return *point;
    return lattice_coarsest(&mesh->lattice, point);
}

/* A record of a table, or else zeroed scratch of the worker's: to be filled
 * unless TABLE_READY, and published if TABLE_MINE. */
static enum table_state record_get(const struct point_mesh *mesh,
                                   struct table *table, struct worker *worker,
                                   const struct lattice_point *point,
                                   size_t size, void **record)
{
    uint64_t key = lattice_key(point);
    enum table_state state = table_find(table, key, lattice_hash(key), record);
    if (state == TABLE_NONE && table_overflown(table))
        atomic_store_explicit(mesh->full, true, memory_order_relaxed);
    if (state == TABLE_NONE)
        *record = arena_alloc(worker->scratch, size);
    return state;
}

static const struct obstacles *around_get(const struct point_mesh *mesh,
                                          struct worker *worker,
                                          const struct lattice_point *point)
{
    void *record;
    enum table_state state = record_get(mesh, mesh->around, worker, point,
                                        sizeof(struct obstacles), &record);
    if (state == TABLE_READY)
        return record;
    obstacles_look(record, mesh->world, lattice_place(&mesh->lattice, point),
                   obstacle_reach *
                       lattice_spacing(&mesh->lattice, point->level));
    if (state == TABLE_MINE)
        table_publish(mesh->around, record);
    return record;
}

struct mesh_watch mesh_watch_start(const struct worker *worker)
{
    return (struct mesh_watch){
        .rays = worker->counters.shadow_rays,
        .others = worker->counters.mesh_rays,
        .seconds = worker->counters.mesh_seconds,
        .start = clock_seconds(),
    };
}

void mesh_watch_stop(const struct mesh_watch *watch,
                     const struct point_mesh *mesh, struct worker *worker)
{
    unsigned long long others = worker->counters.mesh_rays - watch->others;
    unsigned long long rays =
        worker->counters.shadow_rays - watch->rays - others;
    double their_seconds = worker->counters.mesh_seconds - watch->seconds;
    double seconds = clock_seconds() - watch->start - their_seconds;
    worker->counters.mesh_rays += rays;
    worker->counters.mesh_seconds += seconds;
    atomic_fetch_add_explicit(&mesh->work->rays, rays, memory_order_relaxed);
    atomic_fetch_add_explicit(&mesh->work->nanoseconds,
                              (unsigned long long)(fmax(seconds, 0) * 1e9),
                              memory_order_relaxed);
}

static void site_fill(const struct point_mesh *mesh, struct worker *worker,
                      const struct mesh_site *site, void *payload)
{
    struct mesh_watch watch = mesh_watch_start(worker);
    mesh->fill(mesh->context, worker, site, payload);
    mesh_watch_stop(&watch, mesh, worker);
}

static const void *payload_get(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct lattice_point *point)
{
    struct lattice_point shared = point_shared(mesh, point);
    void *record;
    enum table_state state = record_get(mesh, mesh->table, worker, &shared,
                                        mesh->payload_size, &record);
    if (state == TABLE_READY)
        return record;
    struct mesh_site site = {
        .place = lattice_place(&mesh->lattice, &shared),
        .key = lattice_key(&shared),
        .dither = site_dither(&shared),
    };
    if (mesh->walled)
        site.wall = obstacles_plane(
            around_get(mesh, worker, &shared),
            asking_reach * lattice_spacing(&mesh->lattice, shared.level));
    site_fill(mesh, worker, &site, record);
    if (state == TABLE_MINE)
        table_publish(mesh->table, record);
    return record;
}

/* A surface place that looks for its mesh points. */
struct seeker {
    const struct point_mesh *mesh;
    struct worker *worker;
    vec3 place, normal;
    double worth;
    int level, finer; /* levels that may follow it */
    struct mesh_blend *blend;
};

static bool seeker_sees(const struct seeker *seeker,
                        const struct lattice_point *point, vec3 from)
{
    const struct obstacles *around =
        around_get(seeker->mesh, seeker->worker, point);
    vec3 offset = vec3_sub(seeker->place, from);
    if (obstacles_clear(around, offset, seeker->normal))
        return true;
    double length = vec3_length(offset);
    struct ray ray = { seeker->place, vec3_scale(offset, -1 / length) };
    seeker->worker->counters.shadow_rays++;
    return !world_occluded(seeker->mesh->world, &ray,
                           surface_offset(seeker->place), length, -1, NULL,
                           NULL);
}

/* 0 behind the surface, 1 well before it. */
static double seeker_rise(const struct seeker *seeker, vec3 from,
                          double spacing)
{
    double rise = vec3_dot(vec3_sub(from, seeker->place), seeker->normal);
    double t = rise / (seek_rise * spacing);
    if (t <= 0)
        return 0;
    return t >= 1 ? 1 : t * t * (3 - 2 * t);
}

/* Mesh points of one level that are before the surface. */
struct candidates {
    int count;
    struct {
        struct lattice_point point;
        vec3 place;
        double weight;
    } at[INTERPOLATION_POINTS];
};

static void seek_candidates(const struct seeker *seeker,
                            struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_weight weights[INTERPOLATION_POINTS];
    double spacing = lattice_spacing(&mesh->lattice, seeker->level);
    vec3 lifted =
        vec3_along(seeker->place, seeker->normal, seek_lift * spacing);
    vec3 at = lattice_units(&mesh->lattice, seeker->level, lifted);
    int count =
        mesh->interpolation->weights(at, seeker->normal, mesh->radius, weights);
    candidates->count = 0;
    for (int i = 0; i < count; i++) {
        struct lattice_point point;
        point.level = seeker->level;
        memcpy(point.at, weights[i].at, sizeof point.at);
        vec3 from = lattice_place(&mesh->lattice, &point);
        double weight = weights[i].weight * seeker_rise(seeker, from, spacing);
        if (weight <= 0)
            continue;
        candidates->at[candidates->count].point = point;
        candidates->at[candidates->count].place = from;
        candidates->at[candidates->count++].weight = weight;
    }
}

/* Adds all candidates if they know about the same: then it doesn't matter
 * which of them see the place. Returns false, having added none, if not. */
static bool seek_alike(struct seeker *seeker,
                       const struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_blend *blend = seeker->blend;
    double least = HUGE_VAL, most = 0;
    if (!mesh->amount || mesh->interpolation->single)
        return false;
    for (int i = 0; i < candidates->count; i++) {
        const void *payload =
            payload_get(mesh, seeker->worker, &candidates->at[i].point);
        double amount = mesh->amount(payload);
        least = fmin(least, amount);
        most = fmax(most, amount);
        if (most > alike_amounts * least)
            return false;
        blend->at[blend->count + i].payload = payload;
        blend->at[blend->count + i].weight = candidates->at[i].weight;
    }
    blend->count += candidates->count;
    return true;
}

static void seek_seen(struct seeker *seeker,
                      const struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_blend *blend = seeker->blend;
    for (int i = 0; i < candidates->count; i++) {
        const struct lattice_point *point = &candidates->at[i].point;
        if (!seeker_sees(seeker, point, candidates->at[i].place))
            continue;
        blend->at[blend->count].payload =
            payload_get(mesh, seeker->worker, point);
        blend->at[blend->count++].weight = candidates->at[i].weight;
        if (mesh->interpolation->single)
            break;
    }
}

/* Adds the points of one level, whose weights sum to 1. Returns the share of
 * those that can't see the place. */
static double seek_points(struct seeker *seeker)
{
    struct mesh_blend *blend = seeker->blend;
    struct candidates candidates;
    int first = blend->count;
    double sum = 0, all = 0;
    seek_candidates(seeker, &candidates);
    if (!seek_alike(seeker, &candidates))
        seek_seen(seeker, &candidates);
    for (int i = 0; i < candidates.count; i++)
        all += candidates.at[i].weight;
    for (int i = first; i < blend->count; i++)
        sum += blend->at[i].weight;
    for (int i = first; i < blend->count; i++)
        blend->at[i].weight /= sum;
    return all > 0 ? 1 - sum / all : 0;
}

/* The share of the next finer level where this one gave the points from number
 * `first` of the blend on: all if there are none. */
static double seek_finer(const struct seeker *seeker, int first, double hidden)
{
    const struct point_mesh *mesh = seeker->mesh;
    const struct mesh_blend *blend = seeker->blend;
    struct refine_views views;
    if (seeker->finer == 0 || seeker->level == 0 ||
        blend->count > BLEND_POINTS - 2 * INTERPOLATION_POINTS)
        return 0;
    if (blend->count == first)
        return 1;
    views.count = blend->count - first;
    views.hidden = mesh->interpolation->single ? 0 : hidden;
    for (int i = 0; i < views.count; i++) {
        const void *payload = blend->at[first + i].payload;
        views.at[i].weight = blend->at[first + i].weight;
        views.at[i].light =
            mesh->light(mesh->context, seeker->place, seeker->normal, payload);
    }
    return refine_share(&mesh->refinement, refine_difference(&views));
}

/* Gives the points first..middle-1 of a blend one share, those after them the
 * other; points of no share are left out. */
static void blend_share(struct mesh_blend *blend, int first, int middle,
                        double before, double after)
{
    int count = first;
    for (int i = first; i < blend->count; i++) {
        double share = i < middle ? before : after;
        if (share <= 0)
            continue;
        blend->at[count].payload = blend->at[i].payload;
        blend->at[count++].weight = blend->at[i].weight * share;
    }
    blend->count = count;
}

/* Adds the points of one level and, where those differ, of finer ones: their
 * weights sum to `share`. */
static void seek_level(struct seeker seeker, double share)
{
    struct mesh_blend *blend = seeker.blend;
    int first = blend->count;
    double hidden = seek_points(&seeker);
    double finer = seek_finer(&seeker, first, hidden);
    int middle = blend->count;
    if (finer > 0) {
        seeker.level--;
        seeker.finer--;
        seek_level(seeker, 1);
    }
    if (blend->count == middle)
        finer = 0;
    blend_share(blend, first, middle, share * (1 - finer), share * finer);
}

/* The place as a mesh point of its own. */
static void seek_here(struct seeker *seeker)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_site site = { .place = seeker->place,
                              .dither = 0.5,
                              .lone = true,
                              .normal = seeker->normal,
                              .worth = seeker->worth };
    double place[3] = { site.place.x, site.place.y, site.place.z };
    for (int i = 0; i < 3; i++) {
        uint64_t bits;
        memcpy(&bits, &place[i], sizeof bits);
        site.key = random_key(site.key, bits);
    }
    void *payload = arena_alloc(seeker->worker->scratch, mesh->payload_size);
    site_fill(mesh, seeker->worker, &site, payload);
    atomic_fetch_add_explicit(&mesh->work->lone, 1, memory_order_relaxed);
    seeker->blend->count = 1;
    seeker->blend->at[0].payload = payload;
    seeker->blend->at[0].weight = 1;
}

/* Counts the points of all levels as if they were asked for, and is black:
 * whether they differ isn't known any more, so that this is the most there
 * may be. */
static void seek_count(struct seeker seeker)
{
    const struct point_mesh *mesh = seeker.mesh;
    struct candidates candidates;
    for (int i = 0; i <= seeker.finer && i <= seeker.level; i++) {
        struct seeker at = seeker;
        at.level -= i;
        seek_candidates(&at, &candidates);
        for (int k = 0; k < candidates.count; k++) {
            struct lattice_point point =
                point_shared(mesh, &candidates.at[k].point);
            uint64_t key = lattice_key(&point);
            table_want(mesh->table, key, lattice_hash(key));
        }
    }
    seeker.blend->count = 1;
    seeker.blend->at[0].payload =
        arena_alloc(seeker.worker->scratch, mesh->payload_size);
    seeker.blend->at[0].weight = 1;
}

/* How many levels coarser than others. */
static int worth_coarser(double worth)
{
    int levels = 0;
    for (double fine = worth_fine; worth < fine && levels < 3;
         fine /= worth_step)
        levels++;
    return levels;
}

void point_mesh_blend(const struct point_mesh *mesh, struct worker *worker,
                      vec3 place, vec3 normal, double worth,
                      struct mesh_blend *blend)
{
    struct seeker seeker = { .mesh = mesh,
                             .worker = worker,
                             .place = place,
                             .normal = normal,
                             .worth = worth,
                             .finer = mesh->refinement.levels,
                             .blend = blend };
    double coarse;
    seeker.level = lattice_level(&mesh->lattice, place, &coarse);
    int finest = seeker.level - mesh->lattice.coarser;
    seeker.level += worth_coarser(worth);
    if (seeker.level > LATTICE_LEVELS - 2)
        seeker.level = LATTICE_LEVELS - 2;
    blend->count = 0;
    if (atomic_load_explicit(mesh->full, memory_order_relaxed)) {
        seek_count(seeker);
        return;
    }
    seek_level(seeker, 1);
    while (blend->count == 0 && seeker.level > finest) {
        seeker.level--;
        seek_level(seeker, 1);
    }
    if (coarse > 0) {
        int fine = blend->count;
        seeker.level++;
        seek_level(seeker, 1);
        if (blend->count == fine)
            coarse = 0;
        blend_share(blend, 0, fine, 1 - coarse, fine ? coarse : 1);
    }
    if (blend->count == 0)
        seek_here(&seeker);
}

/* The corners of a cell, roughly from near to far: those reached from the
 * nearest by steps along axes, the first of which costs least. */
static void nearest_corners(vec3 at, struct lattice_point corner[8])
{
    double t[3] = { at.x - floor(at.x), at.y - floor(at.y),
                    at.z - floor(at.z) };
    int low[3] = { (int)floor(at.x), (int)floor(at.y), (int)floor(at.z) };
    int axis[3] = { 0, 1, 2 };
    for (int i = 1; i < 3; i++)
        for (int j = i;
             j > 0 && fabs(t[axis[j]] - 0.5) < fabs(t[axis[j - 1]] - 0.5);
             j--) {
            int swap = axis[j];
            axis[j] = axis[j - 1];
            axis[j - 1] = swap;
        }
    for (int steps = 0; steps < 8; steps++)
        for (int i = 0; i < 3; i++) {
            int up = t[axis[i]] >= 0.5, step = steps >> i & 1;
            corner[steps].at[axis[i]] = low[axis[i]] + (up ^ step);
        }
}

const void *point_mesh_nearest(const struct point_mesh *mesh,
                               struct worker *worker, vec3 place, vec3 normal,
                               vec3 jitter)
{
    double coarse;
    struct lattice_point corner[8];
    struct seeker seeker = {
        .mesh = mesh, .worker = worker, .place = place, .normal = normal
    };
    seeker.level = lattice_level(&mesh->lattice, place, &coarse);
    if (atomic_load_explicit(mesh->full, memory_order_relaxed))
        return NULL;
    if (coarse > 0.5)
        seeker.level++;
    double spacing = lattice_spacing(&mesh->lattice, seeker.level);
    vec3 lifted = vec3_along(place, normal, seek_lift * spacing);
    vec3 at = lattice_units(&mesh->lattice, seeker.level, lifted);
    nearest_corners(vec3_add(at, jitter), corner);
    for (int traced = 0; traced < 2; traced++)
        for (int i = 0; i < 8; i++) {
            corner[i].level = seeker.level;
            vec3 from = lattice_place(&mesh->lattice, &corner[i]);
            vec3 offset = vec3_sub(place, from);
            if (-vec3_dot(offset, normal) < nearest_rise * spacing)
                continue;
            if (traced ? seeker_sees(&seeker, &corner[i], from)
                       : obstacles_clear(around_get(mesh, worker, &corner[i]),
                                         offset, normal))
                return payload_get(mesh, worker, &corner[i]);
        }
    return NULL;
}

static bool point_place(const struct point_mesh *mesh, uint64_t key,
                        vec3 *place)
{
    struct lattice_point point = lattice_named(key);
    if (mesh->place)
        return mesh->place(mesh->context, key, place);
    *place = lattice_place(&mesh->lattice, &point);
    return true;
}

void point_mesh_each(const struct point_mesh *mesh, mesh_visit *visit,
                     void *context)
{
    size_t count = table_count(mesh->table);
    for (size_t i = 0; i < count; i++) {
        uint64_t key;
        const void *payload = table_at(mesh->table, i, &key);
        vec3 place;
        if (payload && point_place(mesh, key, &place))
            visit(context, place, payload);
    }
}

size_t point_mesh_refined(const struct point_mesh *mesh)
{
    size_t count = table_count(mesh->table), refined = 0;
    if (mesh->refinement.levels == 0)
        return 0;
    for (size_t i = 0; i < count; i++) {
        uint64_t key;
        double coarser;
        if (!table_at(mesh->table, i, &key))
            continue;
        struct lattice_point point = lattice_named(key);
        vec3 place = lattice_place(&mesh->lattice, &point);
        refined += point.level < lattice_level(&mesh->lattice, place, &coarser);
    }
    return refined;
}
