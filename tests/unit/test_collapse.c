/* skeleton/complex and skeleton/collapse: voids of which the skeleton is known
 * from their making, smooth and rough. */
#include <stdio.h>

#include "harness.h"
#include "skeleton/collapse.h"
#include "skeleton/distance.h"
#include "skeleton/opening.h"
#include "voids.h"

/* The points of a skeleton by how many edges they have. */
struct degrees {
    long ends, alone, junctions;
};

static struct degrees degrees_of(const struct complex *complex)
{
    struct degrees d = { 0, 0, 0 };
    for (size_t i = 0; i < complex->count; i++) {
        int degree = 0;
        cell point = (cell)(8 * i);
        if (!complex_has(complex->cells, point))
            continue;
        for (int axis = 0; axis < 3; axis++) {
            degree += complex_has(complex->cells, cell_above(point, axis));
            degree +=
                complex_has(complex->cells, cell_below(complex, point, axis));
        }
        d.alone += degree == 0;
        d.ends += degree == 1;
        d.junctions += degree > 2;
    }
    return d;
}

struct result {
    long euler_before, euler;
    struct complex_counts counts;
    struct degrees degrees;
    int rounds;
};

static struct result collapse(const struct voxels *v)
{
    struct result r;
    uint16_t *distance = calloc(voxels_count(v), sizeof *distance);
    uint16_t *opening = calloc(voxels_count(v), sizeof *opening);
    struct collapse_maps maps = { distance, opening };
    struct complex *complex = complex_new(v);
    distance_chessboard(v, OUTSIDE_VOID, distance);
    opening_chessboard(v, distance, 1, opening);
    r.euler_before = complex_euler(complex);
    r.rounds = complex_collapse(complex, v, &maps);
    r.euler = complex_euler(complex);
    r.counts = complex_count(complex);
    r.degrees = degrees_of(complex);
    complex_free(complex);
    free(distance);
    free(opening);
    return r;
}

static struct result collapse_case(const struct void_case *what, bool rough)
{
    struct voxels v = void_case_new(what);
    if (rough)
        void_case_roughen(&v, 1);
    struct result r = collapse(&v);
    void_case_free(&v);
    print_message("%s%s: euler %ld, %ld nodes, %ld edges, %ld junctions, "
                  "%ld ends, %d rounds\n",
                  what->name, rough ? " (rough)" : "", r.euler, r.counts.of[0],
                  r.counts.of[1], r.degrees.junctions, r.degrees.ends,
                  r.rounds);
    assert_int_equal(r.euler, r.euler_before);
    assert_int_equal(r.counts.of[2], 0);
    assert_int_equal(r.counts.of[3], 0);
    return r;
}

static void check_shape(const struct result *r, long euler, long nodes,
                        long junctions, long ends)
{
    assert_int_equal(r->euler, euler);
    assert_int_equal(r->counts.of[0], nodes);
    assert_int_equal(r->counts.of[1], nodes - euler);
    assert_int_equal(r->degrees.junctions, junctions);
    assert_int_equal(r->degrees.ends, ends);
}

static void box_is_a_point(void **state)
{
    (void)state;
    struct result r = collapse_case(&void_box, false);
    check_shape(&r, 1, 1, 0, 0);
}

static void u_is_a_curve(void **state)
{
    (void)state;
    struct result r = collapse_case(&void_u, false);
    check_shape(&r, 1, 191, 0, 2);
}

/* The loop round the pillar stays a loop. */
static void rooms_have_a_loop(void **state)
{
    (void)state;
    struct result r = collapse_case(&void_rooms, false);
    check_shape(&r, 0, 298, 2, 2);
    assert_int_equal(r.rounds, 43);
}

static void nine_rooms(void **state)
{
    (void)state;
    struct result r = collapse_case(&void_nine, false);
    check_shape(&r, 1, 298, 1, 3);
}

static void hall_of_pillars(void **state)
{
    (void)state;
    struct result r = collapse_case(&void_hall, false);
    check_shape(&r, -13, 990, 26, 0);
    assert_int_equal(r.rounds, 25);
}

static void rough_walls(void **state)
{
    (void)state;
    collapse_case(&void_box, true);
    collapse_case(&void_u, true);
    collapse_case(&void_nine, true);
    collapse_case(&void_hall, true);
    struct result r = collapse_case(&void_rooms, true);
    assert_in_range(r.degrees.ends, 0, 30);
}

/* Without maps only what holds the void together is left. */
static void ultimate(void **state)
{
    (void)state;
    struct voxels v = void_case_new(&void_u);
    struct complex *complex = complex_new(&v);
    complex_collapse(complex, &v, NULL);
    assert_int_equal(complex_count(complex).of[0], 1);
    assert_int_equal(complex_count(complex).of[1], 0);
    complex_free(complex);
    void_case_free(&v);
}

/* Two voids that share only a corner are one; the border of the grid is no
 * wall that a void may not touch; no void at all is no skeleton. */
static void edges_of_the_grid(void **state)
{
    (void)state;
    uint8_t cube[27];
    struct voxels v = { .size = { 3, 3, 3 }, .edge = 1, .empty = cube };
    memset(cube, 0, sizeof cube);
    struct result r = collapse(&v);
    assert_int_equal(r.counts.of[0], 0);
    cube[0] = cube[13] = cube[26] = 1;
    r = collapse(&v);
    assert_int_equal(r.euler, 1);
    assert_int_equal(r.degrees.alone + r.degrees.ends > 0, 1);
    memset(cube, 1, sizeof cube);
    r = collapse(&v);
    check_shape(&r, 1, 1, 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_is_a_point),
        cmocka_unit_test(u_is_a_curve),
        cmocka_unit_test(rooms_have_a_loop),
        cmocka_unit_test(nine_rooms),
        cmocka_unit_test(hall_of_pillars),
        cmocka_unit_test(rough_walls),
        cmocka_unit_test(ultimate),
        cmocka_unit_test(edges_of_the_grid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
