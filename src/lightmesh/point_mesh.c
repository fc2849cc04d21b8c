/* Points that are computed when they are asked for: see point_mesh.h. */
#include "lightmesh/point_mesh.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"

/* What stands around points is found apart from what they know, in one table:
 * some are found to be hidden, and then need know nothing. */
void point_mesh_start(struct point_mesh *mesh, size_t bytes)
{
    size_t payload = mesh->payload_size + sizeof(void *),
           around = sizeof(struct obstacles) + sizeof(void *);
    size_t share = bytes / (payload + 2 * around);
    mesh->table =
        table_new_beside(&mesh->around, mesh->payload_size, share * payload,
                         sizeof(struct obstacles), 2 * share * around);
    mesh->work = memory_new(sizeof *mesh->work);
}

void point_mesh_free(struct point_mesh *mesh)
{
    table_free(mesh->around);
    table_free(mesh->table);
    memory_free(mesh->work);
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

/* What is around a point is looked for as far as its level says. */
struct lattice_point point_mesh_shared(const struct point_mesh *mesh,
                                       const struct lattice_point *point)
{
    if (mesh->refinement.levels == 0)
        return *point;
    return lattice_coarsest(&mesh->lattice, point);
}

/* A record of a table, or else zeroed scratch of the worker's: to be filled
 * unless TABLE_READY, and published if TABLE_MINE. */
static enum table_state record_get(struct table *table, struct worker *worker,
                                   const struct lattice_point *point,
                                   size_t size, void **record)
{
    uint64_t key = lattice_key(point);
    enum table_state state = table_find(table, key, lattice_hash(key), record);
    if (state == TABLE_NONE)
        *record = arena_alloc(worker->scratch, size);
    return state;
}

const struct obstacles *point_mesh_around(const struct point_mesh *mesh,
                                          struct worker *worker,
                                          const struct lattice_point *point)
{
    void *record;
    enum table_state state = record_get(mesh->around, worker, point,
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

void point_mesh_fill(const struct point_mesh *mesh, struct worker *worker,
                     const struct mesh_site *site, void *payload)
{
    struct mesh_watch watch = mesh_watch_start(worker);
    mesh->fill(mesh->context, worker, site, payload);
    mesh_watch_stop(&watch, mesh, worker);
}

const void *point_mesh_payload(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct lattice_point *point)
{
    struct lattice_point shared = point_mesh_shared(mesh, point);
    void *record;
    enum table_state state =
        record_get(mesh->table, worker, &shared, mesh->payload_size, &record);
    if (state == TABLE_READY)
        return record;
    struct mesh_site site = {
        .place = lattice_place(&mesh->lattice, &shared),
        .key = lattice_key(&shared),
        .dither = site_dither(&shared),
    };
    if (mesh->walled)
        site.wall = obstacles_plane(
            point_mesh_around(mesh, worker, &shared),
            asking_reach * lattice_spacing(&mesh->lattice, shared.level));
    point_mesh_fill(mesh, worker, &site, record);
    if (state == TABLE_MINE)
        table_publish(mesh->table, record);
    return record;
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

int point_mesh_worth(double weight)
{
    int levels = 0;
    for (double fine = worth_fine;
         weight < fine && levels < POINT_MESH_WORTHS - 1; fine /= worth_step)
        levels++;
    return levels;
}

double point_mesh_typical_worth(int levels)
{
    return levels == 0 ? 1 : 0.5 * worth_fine / pow(worth_step, levels - 1);
}

size_t point_mesh_refined(const struct point_mesh *mesh,
                          const struct lattice_view *view)
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
        refined +=
            point.level < lattice_level(&mesh->lattice, view, place, &coarser);
    }
    return refined;
}
