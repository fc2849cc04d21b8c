/* lightmesh/: tables, lattices, interpolation, harmonics, obstacles and light
 * trees, each against what can be computed by hand. */
#include "harness.h"

#include <math.h>

#include "lightmesh/distinct.h"
#include "lightmesh/harmonics.h"
#include "lightmesh/interpolation.h"
#include "lightmesh/lattice.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"
#include "scene_world.h"

static void test_table(void **state)
{
    struct table *table = table_new(sizeof(int), 4000);
    size_t kept = 0;
    (void)state;
    for (uint64_t key = 1; key <= 1000; key++) {
        void *record = NULL;
        enum table_state first = table_find(table, key, key, &record);
        if (first != TABLE_MINE)
            continue;
        *(int *)record = (int)key;
        assert_int_equal(table_find(table, key, key, &record), TABLE_NONE);
        table_publish(table, record);
        kept++;
    }
    assert_int_equal(kept, table_capacity(table));
    assert_int_equal(kept, table_count(table));
    assert_true(kept < 1000);
    for (uint64_t key = 1; key <= kept; key++) {
        void *record = NULL;
        assert_int_equal(table_find(table, key, key, &record), TABLE_READY);
        assert_int_equal(*(int *)record, (int)key);
    }
    table_free(table);
}

/* Two beside each other: a key has a record in either, in both, or in none;
 * each has its own room. */
static void test_beside(void **state)
{
    struct table *around;
    struct table *table =
        table_new_beside(&around, sizeof(int), 4000, sizeof(double), 20000);
    size_t kept[2] = { 0, 0 };
    uint64_t seen;
    void *record, *seen_record;
    (void)state;
    for (uint64_t key = 1; key <= 200; key++) {
        double number = (double)key / 2;
        int whole = -(int)key;
        if (key % 3)
            table_insert(around, key, key, &number);
        if (key % 2 && table_find(table, key, key, &record) == TABLE_MINE) {
            assert_int_equal(table_find(table, key, key, &seen_record),
                             TABLE_NONE);
            *(int *)record = whole;
            table_publish(table, record);
        }
    }
    for (uint64_t key = 1; key <= 200; key++) {
        enum table_state state_around = table_find(around, key, key, &record);
        kept[1] += state_around == TABLE_READY;
        assert_int_equal(state_around == TABLE_READY, key % 3 != 0);
        if (state_around == TABLE_READY)
            assert_true(*(double *)record == (double)key / 2);
    }
    assert_true(table_capacity(around) > table_capacity(table));
    for (size_t i = 0; i < table_count(table); i++) {
        const void *held = table_at(table, i, &seen);
        assert_int_equal(*(const int *)held, -(int)seen);
        kept[0]++;
    }
    assert_true(kept[0] == 100 || kept[0] == table_capacity(table));
    assert_int_equal(kept[1], 134);
    table_free(table);
    table_free(around);
}

static void test_distinct(void **state)
{
    static struct distinct seen;
    (void)state;
    for (uint64_t key = 1; key <= 1000; key++)
        for (int times = 0; times < 3; times++)
            distinct_add(&seen, key);
    assert_true(fabs(distinct_count(&seen) - 1000) < 20);
    for (uint64_t key = 1001; key <= 50000; key++)
        distinct_add(&seen, key);
    assert_true(fabs(distinct_count(&seen) - 50000) < 500);
}

static void test_lattice(void **state)
{
    const struct lattice_view here = { .coarser = 0 };
    const struct lattice_view rough = { .coarser = 1 };
    struct lattice lattice = { .spacing = 0.5, .near = 4 };
    double blend;
    (void)state;
    assert_int_equal(lattice_level(&lattice, &here, vec3_make(0, 0, 1), &blend),
                     0);
    assert_true(blend == 0);
    assert_int_equal(
        lattice_level(&lattice, &here, vec3_make(0, 4.1, 0), &blend), 1);
    assert_int_equal(
        lattice_level(&lattice, &here, vec3_make(8.1, 0, 0), &blend), 2);
    struct lattice kept = lattice;
    const struct lattice_view nearer = { .finest = -1.5 };
    lattice_make_finer(&kept, 3);
    assert_int_equal(lattice_level(&kept, &here, vec3_make(0, 0, 1), &blend),
                     3);
    assert_int_equal(
        lattice_level(&kept, &nearer, vec3_make(0, 0, 0.5), &blend), 1);
    assert_int_equal(lattice_level(&kept, &nearer, vec3_make(0, 0, 3), &blend),
                     3);
    assert_true(lattice_spacing(&kept, 3) == 0.5);
    struct mesh_region box = { { -1, -1, -1 }, { 1, 1, 1 }, 4 };
    struct lattice dense = { .spacing = 0.5 };
    lattice_set_regions(&dense, &box, 1);
    assert_true(lattice_spacing(&dense, 2) == 0.5);
    assert_int_equal(lattice_level(&dense, &here, vec3_make(0, 0, 1), &blend),
                     0);
    assert_int_equal(lattice_level(&dense, &here, vec3_make(0, 1.6, 0), &blend),
                     1);
    assert_true(blend == 0);
    assert_int_equal(
        lattice_level(&dense, &here, vec3_make(0, 1.95, 0), &blend), 1);
    assert_true(fabs(blend - 0.896) < 1e-9);
    assert_int_equal(lattice_level(&dense, &here, vec3_make(9, 0, 0), &blend),
                     2);
    box.factor = 0.5;
    struct lattice thin = { .spacing = 0.5 };
    lattice_set_regions(&thin, &box, 1);
    assert_int_equal(lattice_level(&thin, &here, vec3_make(0, 0, 0), &blend),
                     1);
    assert_int_equal(lattice_level(&thin, &here, vec3_make(0, 0, 1), &blend),
                     0);
    struct lattice_point point = { 2, { -7, 0, 12 } };
    vec3 at = lattice_units(&lattice, 2, lattice_place(&lattice, &point));
    assert_true(fabs(at.x + 7) < 1e-9 && fabs(at.y) < 1e-9);
    assert_true(fabs(at.z - 12) < 1e-9);
    struct lattice_point other = { 1, { -7, 0, 12 } };
    assert_int_equal(
        lattice_level(&lattice, &rough, vec3_make(0, 4.1, 0), &blend), 2);
    assert_true(lattice_key(&point) != lattice_key(&other));
    struct lattice_point named = lattice_named(lattice_key(&other));
    assert_memory_equal(&named, &other, sizeof named);
}

/* Weights never jump: all but the nearest's blends of a smooth function
 * along a line change little from step to step. */
static void test_interpolation(void **state)
{
    struct mesh_weight weights[INTERPOLATION_POINTS];
    vec3 normal = vec3_normalise(vec3_make(1, 2, -2));
    (void)state;
    for (size_t i = 0; interpolation_at(i); i++) {
        const struct interpolation *kind = interpolation_at(i);
        bool jumps = kind->single || kind == interpolation_find("mean");
        double before = 0;
        for (int step = 0; step < 1000; step++) {
            vec3 place = vec3_make(step * 0.003, 0.4 + step * 0.001, -1.3);
            int count = kind->weights(place, normal, kind->radius, weights);
            double sum = 0, value = 0;
            for (int k = 0; k < count && !(kind->single && k > 0); k++) {
                sum += weights[k].weight;
                value += weights[k].weight *
                         (weights[k].at[0] + 2 * weights[k].at[1]);
            }
            assert_true(count > 0 && sum > 0);
            if (step > 0 && !jumps)
                assert_true(fabs(value / sum - before) < 0.05);
            before = value / sum;
        }
    }
    assert_null(interpolation_find("cubic"));
}

/* `smooth` asks no layer but the two around the place, and evens out: points
 * that differ by turns, as those that gather along other ways do, hardly show
 * along the surface. */
static void test_smooth_interpolation(void **state)
{
    const struct interpolation *smooth = interpolation_find("smooth");
    struct mesh_weight weights[INTERPOLATION_POINTS];
    (void)state;
    assert_non_null(smooth);
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (int step = 0; step < 100; step++) {
        vec3 place = vec3_make(step * 0.05, step * 0.03, 0.3);
        int count =
            smooth->weights(place, vec3_make(0, 0, 1), smooth->radius, weights);
        double sum = 0, value = 0;
        for (int k = 0; k < count; k++) {
            const int *at = weights[k].at;
            assert_true(at[2] == 0 || at[2] == 1);
            sum += weights[k].weight;
            value += weights[k].weight * ((at[0] + at[1]) % 2 ? 1 : -1);
        }
        least = fmin(least, value / sum);
        most = fmax(most, value / sum);
    }
    assert_true(least > -0.35 && most < 0.35);
}

/* Even light before a surface lights its bumps as far as they face it, and what
 * is behind it none of them. */
static void test_bump(void **state)
{
    (void)state;
    float before[HARMONICS] = { 0 }, behind[HARMONICS] = { 0 };
    const vec3 side = { 0, 1, 0 };
    const int count = 20000;
    for (int i = 0; i < count; i++) {
        double y = (i + 0.5) / count, turn = 2.4 * i, flat = sqrt(1 - y * y);
        vec3 way = { flat * cos(turn), y, flat * sin(turn) };
        harmonics_add_share(before, way, 2.0 / count);
        harmonics_add_share(behind, vec3_negate(way), 2.0 / count);
    }
    for (double angle = 0; angle < 3.2; angle += 0.5) {
        double weights[HARMONICS], bright = 0, dark = 0;
        harmonics_bump(side, vec3_make(sin(angle), cos(angle), 0), weights);
        for (int i = 0; i < HARMONICS; i++) {
            bright += weights[i] * (double)before[i];
            dark += weights[i] * (double)behind[i];
        }
        assert_float_equal(bright, (1 + cos(angle)) / 2, 0.01);
        assert_float_equal(dark, 0, 0.01);
    }
}

/* Order 2 of max(0, cosine) is 1/4 + cos/2 + 5/32 (3 cos^2 - 1). What is known
 * to come from one direction is exact. */
static void test_harmonics(void **state)
{
    struct harmonics light = { { 0 }, { 0 }, { 0 } };
    vec3 lamp = vec3_normalise(vec3_make(1, 2, -2));
    vec3 normal = vec3_normalise(vec3_make(2, 1, -1));
    double cosine = vec3_dot(lamp, normal);
    double weights[HARMONICS];
    rgb whole;
    (void)state;
    harmonics_add(&light, lamp, rgb_make(1, 2, 0));
    harmonics_weights(normal, 1, weights);
    rgb seen = harmonics_weighted(&light, weights);
    double wanted = 0.25 + cosine / 2 + 5.0 / 32 * (3 * cosine * cosine - 1);
    assert_true(fabs(seen.r - wanted) < 1e-5);
    assert_true(fabs(seen.g - 2 * wanted) < 1e-5);
    assert_true(seen.b == 0);
    seen = harmonics_irradiance(&light, normal, 1);
    assert_true(fabs(seen.r - cosine) < 1e-5);
    assert_true(fabs(seen.g - 2 * cosine) < 1e-5);
    vec3 direction = harmonics_direction(&light, &whole);
    assert_true(vec3_dot(direction, lamp) > 1 - 1e-9);
    assert_true(fabs(whole.r - 1) < 1e-5 && fabs(whole.g - 2) < 1e-5);
}

/* What the plane `slope` . offset = 1 is like from a mesh point. */
static void look_at_plane(struct obstacles *map, vec3 slope, double reach)
{
    for (int i = 0; i < 27; i++) {
        vec3 d = vec3_normalise(vec3_make(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        double near = vec3_dot(slope, d);
        if (i != 13)
            map->near[i > 13 ? i - 1 : i] =
                near * reach > 1 ? (float)near : 0.0f;
    }
}

/* Of a way to a place on the floor. */
static enum sight sight_along(const struct obstacles *map, double x, double y,
                              double z)
{
    return obstacles_sight(map, vec3_make(x, y, z), vec3_make(0, 1, 0));
}

/* A place's own plane doesn't hide it, nor does what is behind that plane or
 * farther than the place. A wall in all directions around the way does, well
 * before the place. */
static void test_obstacles(void **state)
{
    struct obstacles map;
    (void)state;
    look_at_plane(&map, vec3_make(0, -1 / 0.7, 0), HUGE_VAL);
    assert_int_equal(sight_along(&map, 0.3, -0.7, 0.2), SIGHT_CLEAR);
    assert_int_equal(sight_along(&map, 0.27, -0.63, 0.18), SIGHT_CLEAR);
    assert_int_equal(sight_along(&map, 0.33, -0.77, 0.22), SIGHT_UNSURE);
    assert_int_equal(sight_along(&map, 0.3, 2, 0.2), SIGHT_CLEAR);
    assert_int_equal(sight_along(&map, 3, -0.7, 0.2), SIGHT_CLEAR);
    assert_int_equal(sight_along(&map, 3, -0.8, 0.2), SIGHT_UNSURE);
    map.near[13] = 1 / 2.0f; /* a post at x = 2 */
    assert_int_equal(sight_along(&map, 1.8, -0.7, 0.2), SIGHT_CLEAR);
    assert_int_equal(sight_along(&map, 2.5, -0.7, 0.2), SIGHT_UNSURE);
    look_at_plane(&map, vec3_make(0.5, 0, 0), HUGE_VAL);
    assert_int_equal(sight_along(&map, 4.8, 0.7, 0.2), SIGHT_HIDDEN);
    assert_int_equal(sight_along(&map, 2.1, 0.7, 0.2), SIGHT_UNSURE);
}

/* A plane is told from its corners with others, however it is tilted. */
static void test_obstacles_plane(void **state)
{
    struct obstacles map, other;
    vec3 slope = { 0.2, -1, 0.3 }, found;
    (void)state;
    look_at_plane(&map, slope, 2.5);
    found = obstacles_plane(&map, 1.75);
    assert_true(vec3_dot(found, vec3_normalise(slope)) > 1 - 1e-6);
    found = obstacles_plane(&map, 0.5);
    assert_true(vec3_dot(found, found) == 0);
    look_at_plane(&other, vec3_make(-0.5, 0, 0), 2.5);
    for (int i = 0; i < OBSTACLE_DIRECTIONS; i++)
        other.near[i] = fmaxf(other.near[i], map.near[i]);
    assert_true(vec3_dot(obstacles_plane(&other, 1.5), vec3_normalise(slope)) >
                1 - 1e-6);
    found = obstacles_plane(&other, 4);
    assert_true(vec3_dot(found, found) == 0);
}

/* Which side of a smooth triangle a lamp is on is told by the triangle, also
 * when that is moved and mirrored; it faces z = -1, its normals lean. */
static void test_smooth_side(void **state)
{
    static const char *const moves[] = { "", "scale <1, 1, -1>",
                                         "scale <-2, 3, 1>" };
    (void)state;
    for (int i = 0; i < 3; i++) {
        char text[512];
        struct intersection at;
        struct ray ray = { { 0.1, 0.1, -5 }, { 0, 0, 1 } };
        snprintf(text, sizeof text,
                 "smooth_triangle { <-1, -1, 0>, <1, 0, -1>, <1, -1, 0>, "
                 "<1, 0.3, -1>, <0, 2, 0>, <1, 0, -1> %s }",
                 moves[i]);
        struct scene_world *all = scene_world_new(text);
        assert_true(world_closest(all->world, &ray, 0, RAY_CAMERA, &at));
        assert_true(fabs(at.face.z) > 1 - 1e-9);
        assert_true(fabs(at.normal.z) < 0.95);
        assert_true(vec3_dot(at.face, at.normal) > 0);
        scene_world_free(all);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_beside),
        cmocka_unit_test(test_distinct),
        cmocka_unit_test(test_lattice),
        cmocka_unit_test(test_interpolation),
        cmocka_unit_test(test_smooth_interpolation),
        cmocka_unit_test(test_harmonics),
        cmocka_unit_test(test_bump),
        cmocka_unit_test(test_obstacles),
        cmocka_unit_test(test_obstacles_plane),
        cmocka_unit_test(test_smooth_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
