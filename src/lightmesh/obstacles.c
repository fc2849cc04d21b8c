/* Depth maps of 26 directions: see obstacles.h. */
#include "lightmesh/obstacles.h"

#include <stdlib.h>

#include "lightmesh/tuning.h"

enum { OBSTACLES_TOGETHER = OBSTACLE_DIRECTIONS / 2 }; /* in a packet */

/* The directions are numbered (x + 1) + 3 (y + 1) + 9 (z + 1) for x, y, z in
 * -1, 0, 1, without the middle, 13. */
static int obstacle_number(int x, int y, int z)
{
    int number = x + 1 + 3 * (y + 1) + 9 * (z + 1);
    return number > 13 ? number - 1 : number;
}

/* A place as a mesh point sees it. */
struct obstacle_view {
    double length; /* to it */
    vec3 plane;    /* the normal over the distance of its plane, away */
};

/* Those from number `first` on, as many as a packet has room for. */
static void obstacles_look_some(struct obstacles *obstacles,
                                const struct world *world, vec3 place,
                                double reach, int first)
{
    struct rays rays;
    struct world_hit hits[OBSTACLES_TOGETHER];
    struct rays_span span = { { 0 }, { 0 } };
    for (int i = 0; i < OBSTACLES_TOGETHER; i++) {
        int number = first + i, cell = number < 13 ? number : number + 1;
        vec3 way = { cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1 };
        rays_set(&rays, i, place, vec3_normalise(way));
        span.far[i] = reach;
    }
    world_closest_many(world, &rays, &span, OBSTACLES_TOGETHER, RAY_OBSTACLE,
                       hits);
    for (int i = 0; i < OBSTACLES_TOGETHER; i++)
        obstacles->near[first + i] =
            hits[i].leaf ? (float)(1 / fmax(hits[i].hit.t, 1e-30)) : 0;
}

void obstacles_look(struct obstacles *obstacles, const struct world *world,
                    vec3 place, double reach)
{
    obstacles_look_some(obstacles, world, place, reach, 0);
    obstacles_look_some(obstacles, world, place, reach, OBSTACLES_TOGETHER);
}

/* 1/d in a direction. */
static double obstacle_near(const struct obstacles *obstacles, const int way[3])
{
    return (double)obstacles->near[obstacle_number(way[0], way[1], way[2])];
}

/* Whether what stands in a direction leaves the way to the place free: it is
 * that place's own plane, or behind it, or farther than the place is. To a
 * point inside of what lies on a floor its wall is nearly that plane. */
static bool obstacle_spares(double near, const int way[3],
                            const struct obstacle_view *view)
{
    static const double unit[] = { 0, 1, 0.7071067811865476,
                                   0.5773502691896258 };
    int axes = abs(way[0]) + abs(way[1]) + abs(way[2]);
    double along = way[0] * view->plane.x + way[1] * view->plane.y +
                   way[2] * view->plane.z;
    return near * view->length < 1 ||
           near <= along * unit[axes] * (1 + obstacle_plane);
}

/* The axes from the one that the offset is most along to the least. */
static void obstacle_order(const double size[3], int order[3])
{
    int most = size[0] >= size[1] ? 0 : 1;
    most = size[2] > size[most] ? 2 : most;
    int least = most == 0 ? 1 : 0;
    int middle = 3 - most - least;
    bool swapped = size[middle] < size[least];
    order[0] = most;
    order[1] = swapped ? least : middle;
    order[2] = swapped ? middle : least;
}

/* Whether something stands nearly all around: the point may be inside of it. */
static bool obstacles_enclose(const struct obstacles *obstacles)
{
    int met = 0;
    for (int i = 0; i < OBSTACLE_DIRECTIONS; i++)
        met += obstacles->near[i] > 0;
    return met >= OBSTACLES_ENCLOSE;
}

/* 1/d of the place's plane in the direction w is w plane. The offset lies
 * between three of the directions, of which the first is the axis it is most
 * along. */
enum sight obstacles_sight(const struct obstacles *obstacles, vec3 offset,
                           vec3 normal)
{
    double size[3] = { fabs(offset.x), fabs(offset.y), fabs(offset.z) };
    int sign[3] = { offset.x < 0 ? -1 : 1, offset.y < 0 ? -1 : 1,
                    offset.z < 0 ? -1 : 1 };
    double height = vec3_dot(offset, normal);
    struct obstacle_view view = {
        .length = vec3_length(offset),
        .plane =
            height < 0 ? vec3_scale(normal, 1 / height) : vec3_make(0, 0, 0),
    };
    int order[3], way[3] = { 0, 0, 0 };
    bool clear = true, hidden = true;
    obstacle_order(size, order);
    for (int i = 0; i < 3 && (clear || hidden); i++) {
        way[order[i]] = sign[order[i]];
        double near = obstacle_near(obstacles, way);
        bool spares = obstacle_spares(near, way, &view);
        clear = clear && spares;
        hidden = hidden && !spares && near * view.length > obstacle_hides;
    }
    if (clear && !obstacles_enclose(obstacles))
        return SIGHT_CLEAR;
    return hidden && !clear ? SIGHT_HIDDEN : SIGHT_UNSURE;
}

/* 1/d times the length of the offset that this is in axes. */
static double obstacle_slope(const struct obstacles *obstacles,
                             const int way[3])
{
    static const double length[] = { 0, 1, 1.4142135623730951,
                                     1.7320508075688772 };
    int axes = abs(way[0]) + abs(way[1]) + abs(way[2]);
    return length[axes] * obstacle_near(obstacles, way);
}

/* 1/d of the plane that is nearest along an axis, linear in the offset: along
 * other axes it is told by the nearer of two neighbours. */
static vec3 obstacles_slope(const struct obstacles *obstacles)
{
    double slope[3] = { 0, 0, 0 }, most = 0;
    int way[3] = { 0, 0, 0 }, nearest = 0, sign = 1;
    for (int i = 0; i < 6; i++) {
        int axis[3] = { 0, 0, 0 };
        axis[i / 2] = i % 2 ? 1 : -1;
        double near = obstacle_slope(obstacles, axis);
        if (near > most) {
            most = near;
            nearest = i / 2;
            sign = axis[nearest];
        }
    }
    way[nearest] = sign;
    slope[nearest] = sign * most;
    for (int i = 1; i < 3; i++) {
        int axis = (nearest + i) % 3;
        way[axis] = 1;
        double up = obstacle_slope(obstacles, way);
        way[axis] = -1;
        double down = obstacle_slope(obstacles, way);
        way[axis] = 0;
        slope[axis] = up >= down ? up - most : most - down;
    }
    return vec3_make(slope[0], slope[1], slope[2]);
}

vec3 obstacles_plane(const struct obstacles *obstacles, double reach)
{
    const vec3 none = { 0, 0, 0 };
    vec3 slope = obstacles_slope(obstacles);
    double size = vec3_length(slope), far = 1 / reach;
    if (size < far)
        return none;
    for (int i = 0; i < 27; i++) {
        int way[3] = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
        if (i == 13)
            continue;
        vec3 offset = vec3_make(way[0], way[1], way[2]);
        double least = far * vec3_length(offset);
        double wanted = fmax(vec3_dot(slope, offset), least);
        double found = fmax(obstacle_slope(obstacles, way), least);
        if (fabs(found - wanted) > obstacle_plane * size)
            return none;
    }
    return vec3_scale(slope, 1 / size);
}
