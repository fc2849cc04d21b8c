/* Points on triangles: see facet_mesh.h. */
#include "lightmesh/facet_mesh.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/facet_point.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"

enum { SQUARE_DIVISION = 1, DIVISION_MAX = 13, FOUND_MAX = 6 };

static bool facet_key_place(const void *context, uint64_t key, vec3 *place)
{
    const struct facet_mesh *mesh = context;
    struct facet_point point = facet_point_named(key);
    struct facet facet;
    double wide;
    if (!facets_at(mesh->facets, point.triangle, &facet))
        return false;
    *place = facet_point_place(&facet, &point, &wide);
    return true;
}

struct facet_mesh *facet_mesh_new(const struct lamps *lamps,
                                  const struct light_tree *tree,
                                  const struct lattice *lattice, int budget,
                                  size_t bytes)
{
    struct facet_mesh *mesh = memory_new(sizeof *mesh);
    mesh->facets = facets_new(lamps->world);
    mesh->lamps = facet_lamps_new(lamps, tree);
    mesh->budget = budget;
    mesh->points = (struct point_mesh){
        .world = lamps->world,
        .payload_size = sizeof(struct facet_light),
        .lattice = *lattice,
        .place = facet_key_place,
        .context = mesh,
        .around = table_new(sizeof(struct obstacles), 0),
        .table = table_new(sizeof(struct facet_light), bytes),
        .work = memory_new(sizeof *mesh->points.work),
    };
    return mesh;
}

void facet_mesh_free(struct facet_mesh *mesh)
{
    if (!mesh)
        return;
    point_mesh_free(&mesh->points);
    facet_lamps_free(mesh->lamps);
    facets_free(mesh->facets);
    memory_free(mesh);
}

/* A surface point that looks for its mesh points. */
struct facet_seeker {
    const struct facet_mesh *mesh;
    struct worker *worker;
    const struct receiver *receiver;
    struct distinct *wanted; /* to count names in, alone; or NULL */
    struct facet facet;
    enum facet_kind kind;
    bool back;
    double spacing; /* of the lattice */
    double u, v;    /* where it is on the triangle */
    int count;
    struct {
        const struct facet_light *light;
        vec3 place;
        double weight;
    } at[FOUND_MAX];
};

static int seeker_budget(const struct facet_seeker *seeker,
                         enum facet_kind kind)
{
    double budget = seeker->mesh->budget;
    if (kind == FACET_SINGLE)
        budget *= fmin(seeker->facet.size / (asked_fully * seeker->spacing), 1);
    else if (kind == FACET_CELLS)
        budget *= seeker->facet.alone ? asked_cell : asked_shared;
    return (int)fmax(budget, 1);
}

static void seeker_fill(const struct facet_seeker *seeker,
                        const struct facet_point *point, vec3 place,
                        double wide, struct facet_light *light)
{
    const struct facet *facet = &seeker->facet;
    struct mesh_watch watch = mesh_watch_start(seeker->worker);
    struct facet_site site = {
        .place = place,
        .normal = seeker->back ? vec3_negate(facet->normal) : facet->normal,
        .budget = seeker_budget(seeker, point->kind),
        .key = random_mix(facet_point_key(point)),
        .dither = facet_point_dither(point),
    };
    for (int k = 0; k < 2; k++)
        site.edge[k] =
            vec3_scale(vec3_sub(facet->corner[k + 1], facet->corner[0]), wide);
    facet_lamps_ask(seeker->mesh->lamps, seeker->worker, &site, light);
    mesh_watch_stop(&watch, &seeker->mesh->points, seeker->worker);
}

/* The point's record, or one of the worker's own. */
static const struct facet_light *seeker_get(const struct facet_seeker *seeker,
                                            const struct facet_point *point,
                                            vec3 place, double wide)
{
    const struct point_mesh *points = &seeker->mesh->points;
    uint64_t key = facet_point_key(point), hash = lattice_hash(key);
    void *record;
    enum table_state state = table_find(points->table, key, hash, &record);
    if (state == TABLE_READY)
        return record;
    if (state == TABLE_NONE)
        record = arena_alloc(seeker->worker->scratch, points->payload_size);
    seeker_fill(seeker, point, place, wide, record);
    if (state == TABLE_MINE)
        table_publish(points->table, record);
    return record;
}

static void seeker_take(struct facet_seeker *seeker,
                        const struct facet_point *point, double weight)
{
    double wide;
    if (weight <= 0)
        return;
    if (seeker->wanted) {
        distinct_add(seeker->wanted, facet_point_key(point));
        return;
    }
    vec3 place = facet_point_place(&seeker->facet, point, &wide);
    seeker->at[seeker->count].light = seeker_get(seeker, point, place, wide);
    seeker->at[seeker->count].place = place;
    seeker->at[seeker->count++].weight = weight;
}

/* The two points of a chain between which the place is. */
static void seek_chain(struct facet_seeker *seeker, struct facet_point *point,
                       double share)
{
    int n = 1 << point->division;
    double along[3] = { 1 - seeker->u - seeker->v, seeker->u, seeker->v };
    double x = (1 - along[seeker->facet.apex]) * n;
    point->i = (int)fmin(fmax(x, 0), n - 1);
    x = fmin(fmax(x - point->i, 0), 1);
    seeker_take(seeker, point, share * (1 - x));
    point->i++;
    seeker_take(seeker, point, share * x);
}

/* The three corners of the cell, with barycentric weights. */
static void seek_cell(struct facet_seeker *seeker, struct facet_point *point,
                      double share)
{
    int n = 1 << point->division;
    double x = seeker->u * n, y = seeker->v * n;
    int i = (int)fmin(x, n - 1), j = (int)fmin(y, n - 1 - i);
    x -= i;
    y -= j;
    bool upper = x + y > 1 && i + j < n - 1;
    double weight[3] = { x, y, 1 - x - y };
    if (upper) {
        weight[0] = 1 - y;
        weight[1] = 1 - x;
        weight[2] = x + y - 1;
    }
    for (int k = 0; k < 3; k++) {
        point->i = i + (k == 0 || (upper && k == 2));
        point->j = j + (k == 1 || (upper && k == 2));
        seeker_take(seeker, point, share * weight[k]);
    }
}

/* A negative division leaves one point. */
static void seek_points(struct facet_seeker *seeker, int division, double share)
{
    struct facet_point point = {
        .triangle = seeker->facet.number,
        .back = seeker->back,
        .kind = division < 0 ? FACET_SINGLE : seeker->kind,
        .division = division < 0 ? 0 : division,
    };
    if (point.kind == FACET_CHAIN)
        seek_chain(seeker, &point, share);
    else if (point.kind == FACET_CELLS)
        seek_cell(seeker, &point, share);
    else
        seeker_take(seeker, &point, share);
}

static bool seeker_sees(const struct facet_seeker *seeker, vec3 place)
{
    vec3 up = vec3_scale(seeker->receiver->side, facet_lift * seeker->spacing);
    vec3 offset = vec3_sub(place, seeker->receiver->point);
    double length = vec3_length(offset);
    if (!(length > 0))
        return true;
    struct ray ray = { vec3_add(seeker->receiver->point, up),
                       vec3_scale(offset, 1 / length) };
    seeker->worker->counters.shadow_rays++;
    return !world_occluded(
        seeker->mesh->points.world,
        &(struct occlusion){ .ray = &ray, .tmax = length, .light = -1 });
}

/* Whether it doesn't matter which of the points see the place. */
static bool seeker_trusts(const struct facet_seeker *seeker)
{
    double least = HUGE_VAL, most = 0;
    for (int i = 0; i < seeker->count; i++) {
        double amount = facet_light_amount(seeker->at[i].light);
        least = fmin(least, amount);
        most = fmax(most, amount);
    }
    return seeker->facet.alone || most <= alike_amounts * least;
}

static bool seeker_blend(const struct facet_seeker *seeker,
                         struct facet_light *light)
{
    bool trusts = seeker_trusts(seeker), seen[FOUND_MAX];
    double sum = 0;
    for (int i = 0; i < seeker->count; i++) {
        seen[i] = trusts || seeker_sees(seeker, seeker->at[i].place);
        sum += seen[i] ? seeker->at[i].weight : 0;
    }
    if (!(sum > 1e-6))
        return false;
    *light = (struct facet_light){ { 0 }, { 0 }, { 0 } };
    for (int i = 0; i < seeker->count; i++)
        if (seen[i])
            facet_light_mix(light, seeker->at[i].light,
                            seeker->at[i].weight / sum);
    return true;
}

static enum facet_kind facet_kind(const struct facet *facet, double spacing)
{
    double cells = facet->size / spacing, length = facet->longest / spacing;
    double width = 2 * cells * cells / length;
    if (facet->alone && cells < facet_least)
        return FACET_NONE;
    if (facet->square)
        return width < facet_narrow * length || cells < facet_least_square
                   ? FACET_NONE
                   : FACET_CELLS;
    if (length > chain_long && width > chain_thin && width < chain_wide)
        return FACET_CHAIN;
    if (facet->alone)
        return width < facet_narrow * length ? FACET_SINGLE : FACET_CELLS;
    return width < facet_narrow * length || cells < facet_least_shared
               ? FACET_NONE
               : FACET_CELLS;
}

/* How often the edges are halved; below 0: one point is enough. Those of a
 * parallelogram, which are twice as long as it is, at least once. */
static int seeker_division(const struct facet_seeker *seeker)
{
    const struct facet *facet = &seeker->facet;
    double edge = facet->longest, apart = apart_chain;
    if (seeker->kind == FACET_SINGLE)
        return -1;
    if (seeker->kind == FACET_CELLS) {
        edge = 1.5 * facet->size; /* of an equilateral triangle */
        apart = facet->alone ? apart_alone : apart_shared;
    }
    double exact = log2(edge / (apart * seeker->spacing));
    int least = facet->square ? SQUARE_DIVISION : -1;
    return (int)fmin(fmax(floor(exact + 0.5), least), DIVISION_MAX);
}

/* Takes what is known around the receiver. False if it lies on no piece that
 * has mesh points of its own. */
static bool seeker_seek(struct facet_seeker *seeker)
{
    const struct receiver *receiver = seeker->receiver;
    const struct lattice *lattice = &seeker->mesh->points.lattice;
    struct facet *facet = &seeker->facet;
    double coarse;
    seeker->count = 0;
    if (!receiver->at ||
        !facets_find(seeker->mesh->facets, receiver->at, facet))
        return false;
    vec3 middle = facet_place(facet, 1 / 3.0, 1 / 3.0);
    int level = lattice_level(lattice, &receiver->view, middle, &coarse);
    seeker->spacing = lattice_spacing(lattice, level);
    seeker->kind = facet_kind(facet, seeker->spacing);
    if (seeker->kind == FACET_NONE ||
        facet->longest > facet_most * lattice_spacing(lattice, KEPT_LEVELS))
        return false;
    if (!facet->alone) {
        level =
            lattice_level(lattice, &receiver->view, receiver->point, &coarse);
        seeker->spacing = lattice_spacing(lattice, level);
    }
    seeker->back = vec3_dot(receiver->side, facet->normal) < 0;
    facet_locate(facet, receiver->point, &seeker->u, &seeker->v);
    int division = seeker_division(seeker);
    if (division < (facet->square ? SQUARE_DIVISION + 1 : 0))
        coarse = 0;
    seek_points(seeker, division, 1 - coarse);
    if (coarse > 0)
        seek_points(seeker, division - 1, coarse);
    return true;
}

bool facet_mesh_light(const struct facet_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      struct facet_light *light)
{
    struct facet_seeker seeker;
    seeker.mesh = mesh;
    seeker.worker = worker;
    seeker.receiver = receiver;
    seeker.wanted = NULL;
    return seeker_seek(&seeker) && seeker_blend(&seeker, light);
}

bool facet_mesh_want(const struct facet_mesh *mesh,
                     const struct receiver *receiver, struct distinct *wanted)
{
    struct facet_seeker seeker;
    seeker.mesh = mesh;
    seeker.receiver = receiver;
    seeker.wanted = wanted;
    return seeker_seek(&seeker);
}
