/* Distance maps and the opening function against their definitions, on random
 * grids of many sizes, densities and thread counts. */
#include "harness.h"

#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "skeleton/distance.h"
#include "skeleton/opening.h"

static struct voxels random_grid(int number)
{
    static const double shares[] = { 0, 0.001, 0.01, 0.1, 0.5, 1 };
    uint64_t key = random_key(7, (uint64_t)number);
    struct voxels v = { .edge = 1 };
    for (int axis = 0; axis < 3; axis++)
        v.size[axis] = 1 + (int)(14 * random_unit(key + (uint64_t)axis));
    v.empty = malloc(voxels_count(&v));
    for (size_t i = 0; i < voxels_count(&v); i++)
        v.empty[i] = random_unit(random_key(key, i)) >= shares[number % 6];
    return v;
}

static bool is_matter(const struct voxels *v, enum outside outside, int x,
                      int y, int z)
{
    if (x < 0 || x >= v->size[0] || y < 0 || y >= v->size[1] || z < 0 ||
        z >= v->size[2])
        return outside == OUTSIDE_MATTER;
    return !v->empty[voxels_index(v, x, y, z)];
}

static int largest(int a, int b, int c)
{
    a = a > b ? a : b;
    return a > c ? a : c;
}

/* The least of both distances from (x,y,z) to matter. */
static void nearest_matter(const struct voxels *v, enum outside outside,
                           const int *at, int *squared, int *chessboard)
{
    *squared = DISTANCE_NONE;
    *chessboard = largest(v->size[0], v->size[1], v->size[2]);
    for (int z = -1; z <= v->size[2]; z++)
        for (int y = -1; y <= v->size[1]; y++)
            for (int x = -1; x <= v->size[0]; x++) {
                int a = x - at[0], b = y - at[1], c = z - at[2];
                int d2 = a * a + b * b + c * c;
                int d = largest(abs(a), abs(b), abs(c));
                if (!is_matter(v, outside, x, y, z))
                    continue;
                *squared = d2 < *squared ? d2 : *squared;
                *chessboard = d < *chessboard ? d : *chessboard;
            }
}

static void check_distances(const struct voxels *v, enum outside outside,
                            unsigned threads)
{
    size_t count = voxels_count(v);
    int32_t *squared = malloc(count * sizeof *squared);
    uint16_t *chessboard = malloc(count * sizeof *chessboard);
    distance_squared(v, outside, threads, squared);
    distance_chessboard(v, outside, chessboard);
    for (int z = 0; z < v->size[2]; z++)
        for (int y = 0; y < v->size[1]; y++)
            for (int x = 0; x < v->size[0]; x++) {
                size_t i = voxels_index(v, x, y, z);
                int wanted_squared, wanted_chessboard;
                nearest_matter(v, outside, (int[3]){ x, y, z }, &wanted_squared,
                               &wanted_chessboard);
                assert_int_equal(squared[i], wanted_squared);
                assert_int_equal(chessboard[i], wanted_chessboard);
            }
    free(squared);
    free(chessboard);
}

static void distances_are_brute_force(void **state)
{
    (void)state;
    for (int number = 0; number < 24; number++) {
        struct voxels v = random_grid(number);
        unsigned threads = 1 + (unsigned)number % 3;
        check_distances(&v, OUTSIDE_VOID, threads);
        check_distances(&v, OUTSIDE_MATTER, threads);
        free(v.empty);
    }
}

/* Paints the ball of radius distance[centre] around it. */
static void paint(const struct voxels *v, const int *at, int radius,
                  uint16_t *out)
{
    for (int z = at[2] - radius + 1; z < at[2] + radius; z++)
        for (int y = at[1] - radius + 1; y < at[1] + radius; y++)
            for (int x = at[0] - radius + 1; x < at[0] + radius; x++) {
                if (x < 0 || x >= v->size[0] || y < 0 || y >= v->size[1] ||
                    z < 0 || z >= v->size[2])
                    continue;
                uint16_t *o = &out[voxels_index(v, x, y, z)];
                *o = radius > *o ? (uint16_t)radius : *o;
            }
}

static void check_opening(const struct voxels *v, enum outside outside,
                          unsigned threads)
{
    size_t bytes = voxels_count(v) * sizeof(uint16_t);
    uint16_t *distance = malloc(bytes), *swept = malloc(bytes);
    uint16_t *painted = calloc(1, bytes);
    distance_chessboard(v, outside, distance);
    opening_chessboard(v, distance, threads, swept);
    for (int z = 0; z < v->size[2]; z++)
        for (int y = 0; y < v->size[1]; y++)
            for (int x = 0; x < v->size[0]; x++)
                paint(v, (int[3]){ x, y, z },
                      distance[voxels_index(v, x, y, z)], painted);
    assert_memory_equal(swept, painted, bytes);
    opening_chessboard(v, distance, threads, distance);
    assert_memory_equal(distance, painted, bytes);
    free(distance);
    free(swept);
    free(painted);
}

static void opening_is_ball_painting(void **state)
{
    (void)state;
    for (int number = 0; number < 48; number++) {
        struct voxels v = random_grid(number);
        unsigned threads = 1 + (unsigned)number % 3;
        check_opening(&v, OUTSIDE_VOID, threads);
        check_opening(&v, OUTSIDE_MATTER, threads);
        free(v.empty);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_brute_force),
        cmocka_unit_test(opening_is_ball_painting),
    };
    return cmocka_run_group_tests_name("distance", tests, NULL, NULL);
}
