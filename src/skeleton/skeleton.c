/* All steps from voxels to answers: see skeleton.h. */
#include "skeleton/skeleton.h"

#include "base/memory.h"
#include "skeleton/collapse.h"
#include "skeleton/distance.h"
#include "skeleton/entrance.h"
#include "skeleton/heuristic.h"
#include "skeleton/opening.h"

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

uint32_t skeleton_node(const struct skeleton *skeleton, const int place[3])
{
    const struct voxels *v = skeleton->voxels;
    for (int axis = 0; axis < 3; axis++)
        if (place[axis] < 0 || place[axis] >= v->size[axis])
            return GRAPH_NONE;
    return skeleton->nearest[voxels_index(v, place[0], place[1], place[2])];
}

/* Numbers a little too large for any grid, so that they fit in an int. */
static int voxel_coordinate(double at)
{
    return (int)floor(fmin(fmax(at, -2), 1 << 20));
}

static void voxel_at(const struct voxels *v, vec3 point, int place[3])
{
    vec3 at = vec3_scale(vec3_sub(point, v->origin), 1 / v->edge);
    place[0] = voxel_coordinate(at.x);
    place[1] = voxel_coordinate(at.y);
    place[2] = voxel_coordinate(at.z);
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

bool skeleton_search(const struct skeleton *skeleton, int reach,
                     struct skeleton_point *point)
{
    const struct voxels *v = skeleton->voxels;
    int middle[3], place[3];
    double best = (double)INFINITY;
    voxel_at(v, point->position, middle);
    for (int dz = -reach; dz <= reach; dz++)
        for (int dy = -reach; dy <= reach; dy++)
            for (int dx = -reach; dx <= reach; dx++) {
                vec3 offset = vec3_make(dx, dy, dz);
                double cost = vec3_dot(offset, offset) -
                              reach * vec3_dot(point->normal, offset);
                place[0] = middle[0] + dx;
                place[1] = middle[1] + dy;
                place[2] = middle[2] + dz;
                uint32_t node = skeleton_node(skeleton, place);
                if (node == GRAPH_NONE || cost >= best)
                    continue;
                best = cost;
                point->node = node;
                point->around = voxel_closest(v, place, point->position);
            }
    return point->node != GRAPH_NONE;
}

struct skeleton_point skeleton_find(const struct skeleton *skeleton,
                                    vec3 position, vec3 normal)
{
    static const double steps[] = { 0.5, 1, 1.5, 2, 3 };
    struct skeleton_point point = { position, normal, position, GRAPH_NONE,
                                    NULL };
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        int place[3];
        point.around =
            vec3_along(position, normal, steps[i] * skeleton->voxels->edge);
        voxel_at(skeleton->voxels, point.around, place);
        point.node = skeleton_node(skeleton, place);
        if (point.node != GRAPH_NONE)
            return point;
    }
    for (int reach = 1; reach <= 2; reach++)
        if (skeleton_search(skeleton, reach, &point))
            break;
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
    skeleton->voxels = voxels;
    skeleton->seed = options->seed;
    skeleton->threads = options->threads ? options->threads : 1;
    skeleton->stop = options->stop;
    skeleton->heuristic =
        options->heuristic ? options->heuristic : heuristic_at(0);
    if (skeleton_thin(skeleton)) {
        skeleton_light_up(skeleton,
                          options->ways || !skeleton->heuristic->wayless);
        if (skeleton->heuristic->start)
            skeleton->state = skeleton->heuristic->start(skeleton);
    }
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
    struct skeleton_point point = skeleton_find(skeleton, position, normal);
    if (point.node == GRAPH_NONE)
        return (struct skeleton_light){ .indirect = light_outside(
                                            skeleton, position, normal) };
    return skeleton->heuristic->answer(skeleton, worker, &point);
}

rgb skeleton_indirect(const struct skeleton *skeleton, struct worker *worker,
                      vec3 position, vec3 normal, const double *draw)
{
    struct skeleton_point point = skeleton_find(skeleton, position, normal);
    point.draw = draw;
    if (point.node == GRAPH_NONE)
        return light_outside(skeleton, position, normal);
    if (skeleton->heuristic->indirect)
        return skeleton->heuristic->indirect(skeleton, &point);
    return skeleton->heuristic->answer(skeleton, worker, &point).indirect;
}
