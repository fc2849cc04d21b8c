/* All steps from voxels to answers: see skeleton.h. */
#include "skeleton/skeleton.h"

#include <string.h>

#include "base/memory.h"
#include "skeleton/collapse.h"
#include "skeleton/distance.h"
#include "skeleton/entrance.h"
#include "skeleton/heuristic.h"
#include "skeleton/matter.h"
#include "skeleton/opening.h"

enum {
    WAY_VOXELS = 6,    /* so far void is looked for along a ray, */
    AROUND_VOXELS = 2, /* and so far around a point: */
    TRIES = 8,         /* of so many voxels whether the point sees them; of */
    TRIES_SEEN = 2,    /* fewer if even on a ray to it there was no void */
    RAYS = 200 * 1000
};

/* The complex lives no longer than it must. False if it was stopped. */
static bool skeleton_thin(struct skeleton *skeleton)
{
    const struct voxels *v = skeleton->voxels;
    struct complex *complex = complex_new(v);
    size_t count = voxels_count(v);
    uint16_t *distance = memory_new(count * sizeof *distance);
    uint16_t *opening = memory_new(count * sizeof *opening);
    struct collapse_maps maps = { distance, opening, skeleton->stop };
    distance_chessboard(v, OUTSIDE_VOID, distance);
    opening_chessboard(v, distance, skeleton->threads, opening);
    skeleton->rounds = complex_collapse(complex, v, &maps);
    memory_free(distance);
    memory_free(opening);
    if (skeleton_stopped(skeleton)) {
        complex_free(complex);
        return false;
    }
    int32_t *squared = memory_new(count * sizeof *squared);
    distance_squared(v, OUTSIDE_VOID, skeleton->threads, squared);
    skeleton->graph = graph_new(skeleton->arena, complex, v, squared);
    memory_free(squared);
    skeleton->nearest = ARENA_ARRAY(skeleton->arena, uint32_t, count);
    graph_nearest(complex, v, skeleton->nearest);
    complex_free(complex);
    return true;
}

/* Takes a place for the void before the point, if it is void. */
static bool point_take(const struct skeleton *skeleton, vec3 place,
                       struct skeleton_point *point)
{
    point->around = place;
    point->voxel = voxels_empty_at(skeleton->voxels, place);
    return point->voxel != VOXEL_NONE;
}

/* The point of a voxel, not quite its border, that is closest to a point. */
static vec3 voxel_closest(const struct voxels *v, const int place[3],
                          vec3 point)
{
    const vec3 margin = { 0.01, 0.01, 0.01 }, whole = { 1, 1, 1 };
    vec3 corner = vec3_make(place[0], place[1], place[2]);
    vec3 at = vec3_scale(vec3_sub(point, v->origin), 1 / v->edge);
    at = vec3_max(at, vec3_add(corner, margin));
    at = vec3_min(at, vec3_sub(vec3_add(corner, whole), margin));
    return vec3_along(v->origin, at, v->edge);
}

enum { REACH_MOST = 3 };

/* Where a search stands: the void voxels around a point, from good to bad. */
struct search {
    int middle[3];
    int low[3], high[3]; /* of the voxels that it goes through */
    double costs[3][2 * REACH_MOST + 1]; /* along each axis, from low on; */
    double least;                        /* of those along x */
    double cost;                         /* of the last one found, */
    size_t last;                         /* which is this, or VOXEL_NONE */
};

/* Places too far out for any grid stay so, but fit in an int. Near voxels cost
 * little, and those that the normal points to. */
static struct search search_begin(const struct skeleton *skeleton, int reach,
                                  const struct skeleton_point *point)
{
    const struct voxels *v = skeleton->voxels;
    vec3 at = vec3_scale(vec3_sub(point->position, v->origin), 1 / v->edge);
    struct search search = { .cost = -(double)INFINITY,
                             .least = (double)INFINITY,
                             .last = VOXEL_NONE };
    for (int axis = 0; axis < 3; axis++) {
        double place = fmin(fmax(vec3_component(at, axis), -1000), 1 << 20);
        double n = vec3_component(point->normal, axis);
        int middle = (int)floor(place), last = v->size[axis] - 1;
        search.middle[axis] = middle;
        search.low[axis] = middle - reach > 0 ? middle - reach : 0;
        search.high[axis] = middle + reach < last ? middle + reach : last;
        for (int i = search.low[axis]; i <= search.high[axis]; i++) {
            double by = i - middle;
            search.costs[axis][i - search.low[axis]] = by * (by - reach * n);
        }
    }
    for (int i = 0; i <= search.high[0] - search.low[0]; i++)
        search.least = fmin(search.least, search.costs[0][i]);
    return search;
}

/* The next best void voxel after the search's last. */
static bool search_next(const struct skeleton *skeleton, struct search *search,
                        struct skeleton_point *point)
{
    const struct voxels *v = skeleton->voxels;
    double best = (double)INFINITY;
    const int *low = search->low, *high = search->high;
    int found[3] = { 0 };
    size_t last = search->last;
    search->last = VOXEL_NONE;
    for (int z = low[2]; z <= high[2]; z++)
        for (int y = low[1]; y <= high[1]; y++) {
            double row =
                search->costs[2][z - low[2]] + search->costs[1][y - low[1]];
            size_t voxel = voxels_index(v, low[0], y, z);
            if (row + search->least >= best)
                continue;
            for (int x = low[0]; x <= high[0]; x++, voxel++) {
                double cost = row + search->costs[0][x - low[0]];
                if (!v->empty[voxel] || cost >= best || cost < search->cost ||
                    (cost <= search->cost && voxel <= last))
                    continue;
                best = cost;
                search->last = voxel;
                found[0] = x, found[1] = y, found[2] = z;
            }
        }
    search->cost = best;
    point->voxel = search->last;
    if (search->last == VOXEL_NONE)
        return false;
    point->node = skeleton->nearest[point->voxel];
    point->around = voxel_closest(v, found, point->position);
    return true;
}

bool skeleton_search(const struct skeleton *skeleton, int reach,
                     struct skeleton_point *point)
{
    struct search search = search_begin(skeleton, reach, point);
    return search_next(skeleton, &search, point);
}

/* The first void on the way to where the point is seen from: on its side of
 * whatever wall is near. */
static bool find_on_way(const struct skeleton *skeleton, vec3 from,
                        struct skeleton_point *point)
{
    double edge = skeleton->voxels->edge;
    vec3 way = vec3_sub(from, point->position);
    double length = vec3_length(way);
    for (int i = 1; i <= WAY_VOXELS && i * edge < length; i++)
        if (point_take(skeleton,
                       vec3_along(point->position, way, i * edge / length),
                       point))
            return true;
    return false;
}

/* Void around, to which nothing is in the way. */
static bool find_around(const struct skeleton *skeleton, int tries,
                        struct skeleton_point *point)
{
    double off = 1e-3 * skeleton->voxels->edge;
    vec3 eye = vec3_along(point->position, point->normal, off);
    struct search search = search_begin(skeleton, AROUND_VOXELS, point);
    while (tries-- > 0 && search_next(skeleton, &search, point))
        if (!matter_hides(skeleton->world, skeleton->marks, eye, point->around))
            return true;
    return false;
}

/* Void straight before the point. */
static bool find_before(const struct skeleton *skeleton,
                        struct skeleton_point *point)
{
    static const double steps[] = { 0.5, 1, 1.5 };
    double edge = skeleton->voxels->edge;
    for (size_t i = 0; i < sizeof steps / sizeof *steps && !point->faces; i++)
        point->faces = point_take(
            skeleton,
            vec3_along(point->position, point->normal, steps[i] * edge), point);
    return point->faces;
}

bool skeleton_faces(const struct skeleton *skeleton, vec3 position, vec3 normal)
{
    struct skeleton_point point = { .position = position, .normal = normal };
    return find_before(skeleton, &point);
}

/* skeleton_find, but for the node, which not all need. */
static struct skeleton_point find_void(const struct skeleton *skeleton,
                                       vec3 position, vec3 normal, vec3 from)
{
    struct skeleton_point point = { .position = position, .normal = normal };
    if (find_before(skeleton, &point))
        return point;
    bool seen =
        from.x != position.x || from.y != position.y || from.z != position.z;
    if (find_on_way(skeleton, from, &point) ||
        find_around(skeleton, seen ? TRIES_SEEN : TRIES, &point))
        return point;
    point.around = position;
    point.voxel = VOXEL_NONE;
    return point;
}

static void point_name(const struct skeleton *skeleton,
                       struct skeleton_point *point)
{
    point->node = point->voxel == VOXEL_NONE ? GRAPH_NONE
                                             : skeleton->nearest[point->voxel];
}

struct skeleton_point skeleton_find(const struct skeleton *skeleton,
                                    vec3 position, vec3 normal, vec3 from)
{
    struct skeleton_point point = find_void(skeleton, position, normal, from);
    point_name(skeleton, &point);
    return point;
}

struct skeleton *skeleton_new(const struct world *world,
                              const struct scene *scene,
                              const struct voxels *voxels,
                              const struct skeleton_options *options)
{
    struct arena *arena = arena_new(0);
    struct skeleton *skeleton = ARENA_NEW(arena, struct skeleton);
    skeleton->arena = arena;
    skeleton->world = world;
    skeleton->scene = scene;
    skeleton->ambience = ambience_new(world, scene);
    skeleton->voxels = voxels;
    skeleton->seed = options->seed;
    skeleton->rays = options->rays ? options->rays : RAYS;
    skeleton->threads = options->threads ? options->threads : 1;
    skeleton->stop = options->stop;
    skeleton->root = options->root;
    skeleton->heuristic =
        options->heuristic ? options->heuristic : heuristic_at(0);
    skeleton->marks = matter_marks(world, voxels_box(voxels), arena);
    if (skeleton_thin(skeleton)) {
        skeleton_light_up(skeleton);
        if (skeleton->heuristic->start)
            skeleton->state = skeleton->heuristic->start(skeleton);
    }
    skeleton->root = NULL;
    if (skeleton_stopped(skeleton)) {
        skeleton_free(skeleton);
        return NULL;
    }
    return skeleton;
}

void skeleton_free(struct skeleton *skeleton)
{
    if (!skeleton)
        return;
    if (skeleton->state && skeleton->heuristic->finish)
        skeleton->heuristic->finish(skeleton->state);
    arena_free(skeleton->arena);
}

struct pieces_kept *skeleton_keep(const struct skeleton *skeleton)
{
    const struct heuristic *heuristic = skeleton->heuristic;
    return heuristic->pieces
               ? pieces_keep(heuristic->pieces(skeleton), skeleton->voxels)
               : NULL;
}

/* The light without the void's. */
static rgb light_outside(const struct skeleton *skeleton, vec3 position,
                         vec3 normal)
{
    const struct heuristic *heuristic = skeleton->heuristic;
    int place[3];
    if (!heuristic->outside || voxels_find(skeleton->voxels, position, place))
        return rgb_grey(0);
    return heuristic->outside(skeleton, normal);
}

struct skeleton_light skeleton_light(const struct skeleton *skeleton,
                                     struct worker *worker, vec3 position,
                                     vec3 normal)
{
    struct skeleton_point point =
        skeleton_find(skeleton, position, normal, position);
    if (point.node == GRAPH_NONE)
        return (struct skeleton_light){ .indirect = light_outside(
                                            skeleton, position, normal) };
    return skeleton->heuristic->answer(skeleton, worker, &point);
}

/* The cheapest way to the answer's `indirect`. */
static rgb light_indirect(const struct skeleton *skeleton,
                          struct worker *worker,
                          const struct skeleton_point *point)
{
    if (point->node == GRAPH_NONE)
        return light_outside(skeleton, point->position, point->normal);
    if (skeleton->heuristic->indirect)
        return skeleton->heuristic->indirect(skeleton, point);
    return skeleton->heuristic->answer(skeleton, worker, point).indirect;
}

rgb skeleton_indirect(const struct skeleton *skeleton, struct worker *worker,
                      vec3 position, vec3 normal)
{
    struct skeleton_point point =
        skeleton_find(skeleton, position, normal, position);
    return light_indirect(skeleton, worker, &point);
}

bool skeleton_close(const struct skeleton *skeleton, struct worker *worker,
                    vec3 position, vec3 normal, vec3 from, rgb *light)
{
    const struct heuristic *heuristic = skeleton->heuristic;
    struct skeleton_point point = find_void(skeleton, position, normal, from);
    point_name(skeleton, &point);
    *light = heuristic->close && point.voxel != VOXEL_NONE
                 ? heuristic->close(skeleton, &point)
                 : light_indirect(skeleton, worker, &point);
    return rgb_peak(*light) > 0 || point.voxel != VOXEL_NONE;
}
