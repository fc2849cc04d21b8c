/* Distances two by two: see cubes.h. Leaving out what is far takes longer than
 * looking at it, for nobody can predict which it is. The points are kept for
 * the next who asks, who most often is in the same cube: a pixel beside,
 * another sample of a bump. */
#include "scene/cubes.h"

#include "base/pair.h"
#include "scene/noise.h"
#include "scene/noise_cell.h"

enum { CUBES = 27, CUBE_PAIRS = (CUBES + PAIR - 1) / PAIR, CUBES_KEPT = 16 };

/* The points from the middle cube's corner on; what fills up the last pair is
 * far away. */
struct cubes {
    vec3 base;
    bool filled;
    pair at[CUBE_PAIRS][3];
};

static const double far_away = 1e100;

/* How many cubes away it is. */
static vec3 cube_step(int i)
{
    return (vec3){ i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
}

static void cubes_fill(struct cubes *cubes, vec3 base)
{
    cubes->base = base;
    cubes->filled = true;
    for (int axis = 0; axis < 3; axis++)
        cubes->at[CUBE_PAIRS - 1][axis] = pair_of(far_away);
    for (int i = 0; i < CUBES; i++) {
        vec3 step = cube_step(i);
        vec3 cell = vec3_add(base, step);
        vec3 at = vec3_add(step, noise_cell_point(cell.x, cell.y, cell.z));
        cubes->at[i / PAIR][0][i % PAIR] = at.x;
        cubes->at[i / PAIR][1][i % PAIR] = at.y;
        cubes->at[i / PAIR][2][i % PAIR] = at.z;
    }
}

/* Of this thread's. */
static const struct cubes *cubes_around(vec3 base)
{
    static _Thread_local struct cubes kept[CUBES_KEPT];
    double x = base.x, y = base.y, z = base.z;
    uint64_t slot = (uint64_t)plane_below(&x) + 5 * (uint64_t)plane_below(&y) +
                    7 * (uint64_t)plane_below(&z);
    struct cubes *cubes = &kept[slot % CUBES_KEPT];
    if (!cubes->filled || cubes->base.x != base.x || cubes->base.y != base.y ||
        cubes->base.z != base.z)
        cubes_fill(cubes, base);
    return cubes;
}

/* Puts a number among three that increase. */
static void squares_add(double squares[3], double square)
{
    for (int i = 0; i < 3; i++) {
        double larger = squares[i] < square ? square : squares[i];
        squares[i] = squares[i] < square ? squares[i] : square;
        square = larger;
    }
}

/* The squares of the distances of a pair of points. */
static inline pair pair_squares(const pair at[3], const pair place[3])
{
    pair dx = at[0] - place[0], dy = at[1] - place[1], dz = at[2] - place[2];
    return dx * dx + dy * dy + dz * dz;
}

void cubes_nearest(vec3 base, vec3 place, double squares[3])
{
    const struct cubes *cubes = cubes_around(base);
    const pair from[3] = { pair_of(place.x), pair_of(place.y),
                           pair_of(place.z) };
    pair first = pair_of(HUGE_VAL), second = first, third = first;
    for (int i = 0; i < CUBE_PAIRS; i++) {
        pair square = pair_squares(cubes->at[i], from);
        pair more = pair_max(first, square);
        first = pair_min(first, square);
        square = pair_max(second, more);
        second = pair_min(second, more);
        third = pair_min(third, square);
    }
    squares[0] = first[0];
    squares[1] = second[0];
    squares[2] = third[0];
    squares_add(squares, first[1]);
    squares_add(squares, second[1]);
    squares_add(squares, third[1]);
}

vec3 cubes_first(vec3 base, vec3 place, double *square)
{
    const struct cubes *cubes = cubes_around(base);
    const pair from[3] = { pair_of(place.x), pair_of(place.y),
                           pair_of(place.z) };
    pair squares[CUBE_PAIRS], first = pair_of(HUGE_VAL);
    unsigned which = 0;
    for (int i = 0; i < CUBE_PAIRS; i++) {
        squares[i] = pair_squares(cubes->at[i], from);
        first = pair_min(first, squares[i]);
    }
    *square = first[0] < first[1] ? first[0] : first[1];
    for (int i = 0; i < CUBE_PAIRS; i++)
        which |= (unsigned)pair_ordered(squares[i], pair_of(*square))
                 << PAIR * i;
    return cube_step(which ? __builtin_ctz(which) : 0);
}

vec3 cubes_point(vec3 base, vec3 step)
{
    const struct cubes *cubes = cubes_around(base);
    int i = (int)(step.x + 3 * step.y + 9 * step.z) + CUBES / 2;
    const pair *at = cubes->at[i / PAIR];
    return (vec3){ at[0][i % PAIR], at[1][i % PAIR], at[2][i % PAIR] };
}
