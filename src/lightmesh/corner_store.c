/* Corners that are kept: see corner_store.h. */
#include "lightmesh/corner_store.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/seek_sight.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "scene/camera.h"
#include "shade/shadow.h"

enum { CELLS_ACROSS = 8, CELLS_DOWN = 4, CELL_LEVELS = 4 };

struct cells {
    struct corner_cell *last[CELL_LEVELS];
    struct corner_cell at[CELL_LEVELS][CELLS_DOWN][CELLS_ACROSS];
};

struct corner_store *corner_store_new(const struct indirect_mesh *mesh,
                                      const struct camera *camera,
                                      const struct surface_grid *grid,
                                      unsigned threads)
{
    struct corner_store *store = memory_new(sizeof *store);
    *store = (struct corner_store){
        .mesh = mesh,
        .camera = camera,
        .grid = grid,
        .threads = threads,
        .cells = memory_new(threads * sizeof(struct cells)),
    };
    store->corners = table_new_beside(
        &store->lights, sizeof(struct corner), INDIRECT_PIXELS_BYTES / 2,
        sizeof(struct corner_light), INDIRECT_PIXELS_BYTES / 2);
    return store;
}

void corner_store_free(struct corner_store *store)
{
    table_free(store->lights);
    table_free(store->corners);
    memory_free(store->cells);
    memory_free(store);
}

/* A record of the table, or else the worker's: to be filled unless
 * TABLE_READY, and published if TABLE_MINE. */
static enum table_state corner_record(struct table *table,
                                      struct worker *worker, uint64_t key,
                                      void **record)
{
    enum table_state state = table_find(table, key, random_mix(key), record);
    if (state == TABLE_NONE)
        *record = arena_alloc(worker->scratch, table_record_size(table));
    return state;
}

struct corner_cell *corner_store_cell(const struct corner_store *store,
                                      const struct worker *worker,
                                      const struct grid_cell *name, int coarser,
                                      struct corner_cell *own)
{
    struct corner_cell *cell = own;
    if (worker->number < store->threads) {
        struct cells *cells = &store->cells[worker->number];
        unsigned column = (unsigned)name->at[0] % CELLS_ACROSS;
        unsigned row = (unsigned)name->at[1] % CELLS_DOWN;
        unsigned level = (unsigned)name->level % CELL_LEVELS;
        cells->last[level] = cell = &cells->at[level][row][column];
        if (cell->used && cell->coarser == coarser &&
            grid_cells_same(&cell->name, name))
            return cell;
    }
    *cell =
        (struct corner_cell){ .name = *name, .coarser = coarser, .used = true };
    return cell;
}

struct corner_cell *corner_store_last(const struct corner_store *store,
                                      const struct worker *worker, int level)
{
    if (worker->number >= store->threads)
        return NULL;
    struct corner_cell *cell =
        store->cells[worker->number].last[(unsigned)level % CELL_LEVELS];
    return cell && cell->name.level == level ? cell : NULL;
}

/* Whether the camera sees the corner, from so little above it: else it may be
 * in a body that stands on its surface. Cameras that don't look from one place
 * say yes. */
static bool corner_shows(const struct corner_store *store,
                         struct worker *worker, const struct corner *corner,
                         double step)
{
    const struct camera *camera = store->camera;
    if (camera->kind->lines != CAMERA_CENTRAL)
        return true;
    vec3 from =
        vec3_along(corner->point, corner->side, indirect_pixels_lift * step);
    vec3 way = vec3_sub(camera->location, from);
    double length = vec3_length(way);
    if (!(length > 0))
        return true;
    const struct receiver place = { .point = from, .side = corner->side };
    rgb through;
    return seek_looks_through(&store->mesh->points, worker, &place,
                              camera->location, &through);
}

/* The surface that the corner's line meets first. */
static void corner_look(struct corner *corner, const struct corner_store *store,
                        struct worker *worker, const struct corner_cell *cell,
                        int i, const struct receiver *like)
{
    struct intersection at;
    double length;
    struct ray line = grid_corner_line(store->grid, &cell->name, i, &length);
    corner->met = false;
    corner->reach = 0;
    const struct glimpse glimpse = { 0, length, gather_spread };
    if (world_glimpse(store->mesh->points.world, &line, glimpse, RAY_SIGHT,
                      &at)) {
        corner_meet(corner, store->mesh, like, &line, &at);
        /* Far off a cell may be larger than those of the mesh. */
        corner->reach = fmax(corner->reach, length);
        corner->met = corner_shows(store, worker, corner, length);
        if (like->far_side)
            corner_turn(corner);
    }
}

const struct corner *corner_store_corner(const struct corner_store *store,
                                         struct worker *worker,
                                         struct corner_cell *cell, int i,
                                         const struct receiver *like)
{
    void *record;
    if (cell->corner[i])
        return cell->corner[i];
    uint64_t key = grid_corner_key(&cell->name, i, cell->coarser, 0);
    enum table_state state =
        corner_record(store->corners, worker, key, &record);
    if (state != TABLE_NONE)
        cell->corner[i] = record;
    if (state == TABLE_READY)
        return record;
    corner_look(record, store, worker, cell, i, like);
    if (state == TABLE_MINE)
        table_publish(store->corners, record);
    return record;
}

/* A place that asks for indirect light, and its name. */
struct light_place {
    uint64_t key;
    const struct corner *corner;
    int coarser;
};

/* What it gets, and whether that is kept. */
static const struct corner_light *light_at(const struct corner_store *store,
                                           struct worker *worker,
                                           const struct light_place *place,
                                           const struct receiver *like,
                                           bool *kept)
{
    void *record;
    enum table_state state =
        corner_record(store->lights, worker, place->key, &record);
    *kept = state != TABLE_NONE;
    if (state == TABLE_READY)
        return record;
    struct receiver receiver =
        corner_receiver(place->corner, like, place->coarser);
    corner_ask(record, store->mesh, worker, &receiver, &store->mesh->near);
    if (state == TABLE_MINE)
        table_publish(store->lights, record);
    return record;
}

const struct corner_light *corner_store_light(const struct corner_store *store,
                                              struct worker *worker,
                                              struct corner_cell *cell, int i,
                                              const struct receiver *like)
{
    bool kept;
    if (cell->light[i])
        return cell->light[i];
    const struct light_place place = {
        grid_corner_key(&cell->name, i, cell->coarser, 0),
        corner_store_corner(store, worker, cell, i, like), cell->coarser
    };
    const struct corner_light *light =
        light_at(store, worker, &place, like, &kept);
    if (kept)
        cell->light[i] = light;
    return light;
}

struct indirect_share corner_store_share(const struct corner_store *store,
                                         struct worker *worker,
                                         struct corner_cell *cell, int i,
                                         const struct receiver *like)
{
    bool kept;
    const struct cell_place *found = &cell->place[i];
    if (found->way == 0)
        return corner_store_light(store, worker, cell, i, like)->share;
    const struct light_place place = {
        grid_corner_key(&cell->name, i, cell->coarser, found->way),
        &found->corner, cell->coarser
    };
    return light_at(store, worker, &place, like, &kept)->share;
}
