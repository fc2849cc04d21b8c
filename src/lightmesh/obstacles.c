/* Depth maps of 26 directions: see obstacles.h. */
#include "lightmesh/obstacles.h"

/* A surface may be this much nearer than its interpolated distance. */
static const double plane_tolerance = 0.03;

/* The directions are numbered (x + 1) + 3 (y + 1) + 9 (z + 1) for x, y, z in
 * -1, 0, 1, without the middle, 13. */
static int obstacle_number(int x, int y, int z)
{
    int number = x + 1 + 3 * (y + 1) + 9 * (z + 1);
    return number > 13 ? number - 1 : number;
}

void obstacles_look(struct obstacles *obstacles, const struct world *world,
                    vec3 place, double reach)
{
    for (int i = 0; i < 27; i++) {
        struct ray ray = { place,
                           vec3_make(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1) };
        struct intersection at;
        if (i == 13)
            continue;
        int number = i > 13 ? i - 1 : i;
        ray.direction = vec3_normalise(ray.direction);
        obstacles->near[number] = 0;
        if (world_within(world, &ray, 0, reach, RAY_OBSTACLE, &at))
            obstacles->near[number] = (float)(1 / fmax(at.t, 1e-30));
    }
}

/* In a corner 1/d is the largest of several planes, so that what lies between
 * three directions is nearer by interpolation than in truth: that a place is
 * before them is sure, that it is behind is not.
 *
 * With |x| >= |y| >= |z|, the direction is (x-y) (1,0,0) + (y-z) (1,1,0) +
 * z (1,1,1), and so is 1/d of a plane. */
bool obstacles_clear(const struct obstacles *obstacles, vec3 offset)
{
    double size[3] = { fabs(offset.x), fabs(offset.y), fabs(offset.z) };
    int sign[3] = { offset.x < 0 ? -1 : 1, offset.y < 0 ? -1 : 1,
                    offset.z < 0 ? -1 : 1 };
    int most = size[0] >= size[1] ? 0 : 1;
    most = size[2] > size[most] ? 2 : most;
    int least = most == 0 ? 1 : 0;
    int middle = 3 - most - least;
    if (size[middle] < size[least]) {
        int swap = middle;
        middle = least;
        least = swap;
    }
    int way[3] = { 0, 0, 0 };
    way[most] = sign[most];
    double a = (double)obstacles->near[obstacle_number(way[0], way[1], way[2])];
    way[middle] = sign[middle];
    double b = (double)obstacles->near[obstacle_number(way[0], way[1], way[2])];
    way[least] = sign[least];
    double c = (double)obstacles->near[obstacle_number(way[0], way[1], way[2])];
    double length = vec3_length(offset);
    double nearest = fmax(a, fmax(b, c)), farthest = fmin(a, fmin(b, c));
    if (nearest * length < 1)
        return true;
    double plane = a * (size[most] - size[middle]) +
                   b * (size[middle] - size[least]) * 1.4142135623730951 +
                   c * size[least] * 1.7320508075688772;
    return farthest > 0 && plane < 1 + plane_tolerance;
}
