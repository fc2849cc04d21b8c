/* Tests of way_cells.h: which ways are looked at more closely, and by which. */
#include "harness.h"

#include <math.h>

#include "lightmesh/way_cells.h"

enum { SAMPLES = 128 };

static double way_between(vec3 a, vec3 b)
{
    return acos(fmin(fmax(vec3_dot(a, b), -1), 1));
}

/* Each way of the set is in the cell of the part's way that is nearest, once.
 */
static void cells_are_nearest(void **state)
{
    struct gather_ways ways = gather_ways_new(SAMPLES);
    struct way_cells cells = way_cells_new(&ways, SAMPLES);
    (void)state;
    assert_int_equal(cells.count, SAMPLES);
    for (uint32_t p = 0; p < GATHER_PARTS; p++) {
        const struct part_cells *part = &cells.part[p];
        bool seen[GATHER_PARTS * SAMPLES] = { false };
        assert_int_equal(part->first[0], 0);
        assert_int_equal(part->first[SAMPLES], GATHER_PARTS * SAMPLES);
        for (uint32_t cell = 0; cell < SAMPLES; cell++)
            for (uint32_t i = part->first[cell]; i < part->first[cell + 1];
                 i++) {
                vec3 way = ways.ways[part->ways[i]];
                double own = way_between(way, ways.ways[p * ways.set + cell]);
                assert_false(seen[part->ways[i]]);
                seen[part->ways[i]] = true;
                for (uint32_t k = 0; k < SAMPLES; k++)
                    assert_true(own <=
                                way_between(way, ways.ways[p * ways.set + k]) +
                                    1e-6);
            }
    }
    way_cells_free(&cells);
    gather_ways_free(&ways);
}

/* Half of them: as where others are aimed. */
static void half_of_the_ways(void **state)
{
    struct gather_ways ways = gather_ways_new(SAMPLES);
    struct way_cells cells = way_cells_new(&ways, SAMPLES / 2);
    (void)state;
    for (uint32_t p = 0; p < GATHER_PARTS; p++)
        for (uint32_t i = 0; i < GATHER_PARTS * SAMPLES / 2; i++)
            assert_true(cells.part[p].ways[i] % ways.set < SAMPLES / 2);
    way_cells_free(&cells);
    gather_ways_free(&ways);
}

static void none_of_too_many(void **state)
{
    struct gather_ways ways = gather_ways_new(2 * WAY_CELLS_MOST);
    struct way_cells cells = way_cells_new(&ways, 2 * WAY_CELLS_MOST);
    (void)state;
    assert_int_equal(cells.count, 0);
    way_cells_free(&cells);
    gather_ways_free(&ways);
}

/* Bright above z = 0: the cells along the equator, and no others, by far. */
static void edges_are_found(void **state)
{
    struct gather_ways ways = gather_ways_new(SAMPLES);
    struct way_cells cells = way_cells_new(&ways, SAMPLES);
    double brought[SAMPLES], across = 2 * sqrt(4 * acos(-1) / SAMPLES);
    bool edge[SAMPLES];
    int near = 0, found = 0;
    (void)state;
    for (uint32_t i = 0; i < SAMPLES; i++)
        brought[i] = ways.ways[i].z > 0 ? 1 : 0;
    way_cells_edges(&cells, 0, brought, 0.5, edge);
    for (uint32_t i = 0; i < SAMPLES; i++) {
        double height = fabs(asin(ways.ways[i].z));
        near += height < across / 6;
        found += edge[i] && height < across / 6;
        assert_false(edge[i] && height > across);
    }
    assert_true(near > 10);
    assert_int_equal(found, near);
    way_cells_edges(&cells, 0, brought, 1.5, edge);
    for (uint32_t i = 0; i < SAMPLES; i++)
        assert_false(edge[i]);
    way_cells_free(&cells);
    gather_ways_free(&ways);
}

/* What was not sent differs from nothing. */
static void unsent_ways_have_no_edge(void **state)
{
    struct gather_ways ways = gather_ways_new(SAMPLES);
    struct way_cells cells = way_cells_new(&ways, SAMPLES);
    double brought[SAMPLES];
    bool edge[SAMPLES];
    (void)state;
    for (uint32_t i = 0; i < SAMPLES; i++)
        brought[i] = ways.ways[i].z > 0 ? 1 : (double)NAN;
    way_cells_edges(&cells, 0, brought, 0.1, edge);
    for (uint32_t i = 0; i < SAMPLES; i++)
        assert_false(edge[i]);
    way_cells_free(&cells);
    gather_ways_free(&ways);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_nearest),
        cmocka_unit_test(half_of_the_ways),
        cmocka_unit_test(none_of_too_many),
        cmocka_unit_test(edges_are_found),
        cmocka_unit_test(unsent_ways_have_no_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
