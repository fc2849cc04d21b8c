/* Corners that are kept: see corner_store.h. */
#include "lightmesh/corner_store.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "scene/camera.h"
#include "shade/shadow.h"

/* Of a cell's step: what is no higher is on one plane, but for rounding. */
static const double cell_thickness = 1e-6;

enum { CELLS_ACROSS = 8, CELLS_DOWN = 4, CELL_LEVELS = 4 };

struct cells {
    struct corner_cell at[CELL_LEVELS][CELLS_DOWN][CELLS_ACROSS];
};

struct corner_store {
    const struct indirect_mesh *mesh;
    const struct camera *camera;
    const struct surface_grid *grid;
    struct table *corners; /* where they are, and beside, by the same keys, */
    struct table *lights;  /* what those know that served */
    unsigned threads;
    struct cells *cells; /* of each worker */
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
        unsigned column = (unsigned)name->at[0] % CELLS_ACROSS;
        unsigned row = (unsigned)name->at[1] % CELLS_DOWN;
        unsigned level = (unsigned)name->level % CELL_LEVELS;
        cell = &store->cells[worker->number].at[level][row][column];
        if (cell->used && cell->coarser == coarser &&
            grid_cells_same(&cell->name, name))
            return cell;
    }
    *cell =
        (struct corner_cell){ .name = *name, .coarser = coarser, .used = true };
    return cell;
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
    struct ray ray = { from, vec3_scale(way, 1 / length) };
    worker->counters.shadow_rays++;
    return !world_occluded(store->mesh->points.world,
                           &(struct occlusion){ .ray = &ray,
                                                .tmin = surface_offset(from),
                                                .tmax = length,
                                                .light = -1,
                                                .spread = gather_spread });
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
    const struct glimpse glimpse = { 0, length, gather_spread };
    if (world_glimpse(store->mesh->points.world, &line, glimpse, RAY_CAMERA,
                      &at)) {
        corner_meet(corner, store->mesh, like, &line, &at);
        /* Far off a cell may be larger than those of the mesh. */
        corner->reach = fmax(corner->reach, length);
        corner->met = corner_shows(store, worker, corner, length);
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
    uint64_t key = grid_corner_key(&cell->name, i, cell->coarser);
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

const struct corner_light *corner_store_light(const struct corner_store *store,
                                              struct worker *worker,
                                              struct corner_cell *cell, int i,
                                              const struct receiver *like)
{
    void *record;
    if (cell->light[i])
        return cell->light[i];
    uint64_t key = grid_corner_key(&cell->name, i, cell->coarser);
    enum table_state state = corner_record(store->lights, worker, key, &record);
    if (state != TABLE_NONE)
        cell->light[i] = record;
    if (state == TABLE_READY)
        return record;
    const struct corner *corner =
        corner_store_corner(store, worker, cell, i, like);
    struct receiver receiver = corner_receiver(corner, like, cell->coarser);
    corner_ask(record, store->mesh, worker, &receiver, &store->mesh->near);
    if (state == TABLE_MINE)
        table_publish(store->lights, record);
    return record;
}

/* Normals that are the same but for rounding. */
static bool sides_agree(vec3 a, vec3 b)
{
    return vec3_dot(a, b) > 1 - 1e-9;
}

static bool on_plane(const struct corner_cell *cell, vec3 point)
{
    vec3 between = vec3_sub(point, cell->at[0]);
    return fabs(vec3_dot(between, cell->side)) <= cell->thick;
}

static bool on_cell(const struct corner_cell *cell,
                    const struct receiver *receiver)
{
    return sides_agree(receiver->side, cell->side) &&
           on_plane(cell, receiver->point);
}

/* The plane that the first corner is on. Returns whether there is one. */
static bool cell_plane(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    const struct corner *corner =
        corner_store_corner(store, worker, cell, 0, like);
    cell->thick = cell_thickness * store->grid->step[cell->name.level];
    cell->at[0] = corner->point;
    cell->side = corner->side;
    return corner->met;
}

/* Whether the others are on it. Says the same whoever asks first. */
static bool cell_flat(const struct corner_store *store, struct worker *worker,
                      struct corner_cell *cell, const struct receiver *like)
{
    cell->reach2 = HUGE_VAL;
    for (int i = 0; i < GRID_CORNERS; i++) {
        const struct corner *corner =
            corner_store_corner(store, worker, cell, i, like);
        if (!corner->met || !sides_agree(corner->side, cell->side) ||
            !on_plane(cell, corner->point))
            return false;
        cell->at[i] = corner->point;
        cell->reach2 = fmin(cell->reach2, corner->reach * corner->reach);
    }
    return true;
}

/* What is not on the plane of the first corner needs no others. */
static bool cell_bends(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell,
                       const struct receiver *receiver)
{
    if (cell->flat == 0 && !cell_plane(store, worker, cell, receiver))
        cell->flat = -1;
    if (cell->flat < 0 || !on_cell(cell, receiver))
        return true;
    if (cell->flat == 0)
        cell->flat = cell_flat(store, worker, cell, receiver) ? 1 : -1;
    return cell->flat < 0;
}

enum corner_hold corner_cell_holds(const struct corner_store *store,
                                   struct worker *worker,
                                   struct corner_cell *cell,
                                   const struct receiver *receiver)
{
    double apart[GRID_CORNERS];
    if (cell_bends(store, worker, cell, receiver))
        return CELL_BENT;
    for (int i = 0; i < GRID_CORNERS; i++) {
        vec3 between = vec3_sub(receiver->point, cell->at[i]);
        apart[i] = vec3_dot(between, between);
    }
    bool near = apart[0] <= cell->reach2 && apart[1] <= cell->reach2 &&
                apart[2] <= cell->reach2 && apart[3] <= cell->reach2;
    return near ? CELL_HOLDS : CELL_FAR;
}

double shares_differ(const struct indirect_share *const *shares, int count)
{
    double least = HUGE_VAL, most = 0;
    for (int i = 0; i < count; i++) {
        double amount = rgb_brightness(shares[i]->light) +
                        indirect_pixels_open * shares[i]->open;
        least = fmin(least, amount);
        most = fmax(most, amount);
    }
    return (most - least) / (most + indirect_pixels_dim);
}

void corner_cell_ask(const struct corner_store *store, struct worker *worker,
                     struct corner_cell *cell, const struct receiver *like)
{
    const struct indirect_share *shares[GRID_CORNERS];
    if (cell->told)
        return;
    for (int i = 0; i < GRID_CORNERS; i++) {
        cell->share[i] =
            corner_store_light(store, worker, cell, i, like)->share;
        shares[i] = &cell->share[i];
    }
    cell->differ = shares_differ(shares, GRID_CORNERS);
    cell->told = true;
}

static bool cell_clear(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    for (int i = 0; i < GRID_CORNERS; i++) {
        const struct corner *corner =
            corner_store_corner(store, worker, cell, i, like);
        if (!corner->met)
            return false;
        for (int j = 0; j < i; j++) {
            const struct receiver other = corner_receiver(
                corner_store_corner(store, worker, cell, j, like), like,
                cell->coarser);
            if (!corner_sees(corner, store->mesh, worker, &other))
                return false;
        }
    }
    return true;
}

bool corner_store_clear(const struct corner_store *store, struct worker *worker,
                        struct corner_cell *cell, const struct receiver *like)
{
    if (cell->clear == 0)
        cell->clear = cell_clear(store, worker, cell, like) ? 1 : -1;
    return cell->clear > 0;
}
