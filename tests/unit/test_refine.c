/* Adaptive meshes: levels of the lattice nest, points have one name on all of
 * them, nothing is filled twice, and finer points come in without a seam. */
#include "harness.h"

#include <math.h>

#include "base/memory.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/table.h"
#include "scene_world.h"

enum { FILLS_MAX = 20000 };

/* The places that were filled. */
struct fills {
    vec3 at[FILLS_MAX];
    int count;
};

/* A floor under a light that is 1 left of x = 0.31 and 3 right of it, but for
 * a ramp of 0.02. */
struct stage {
    struct scene_world *all;
    struct worker worker;
    struct point_mesh mesh;
    bool even; /* 1 everywhere */
    struct fills *fills;
};

static double stage_light(const struct stage *stage, vec3 place)
{
    double t = (place.x - 0.31) / 0.02;
    return stage->even ? 1 : 1 + 2 * fmin(fmax(t, 0), 1);
}

static void stage_fill(const void *context, struct worker *worker,
                       const struct mesh_site *site, void *payload)
{
    const struct stage *stage = context;
    (void)worker;
    assert_true(stage->fills->count < FILLS_MAX);
    stage->fills->at[stage->fills->count++] = site->place;
    *(double *)payload = stage_light(stage, site->place);
}

static rgb stage_view(const void *context, vec3 place, vec3 normal,
                      const void *payload)
{
    (void)context;
    (void)place;
    (void)normal;
    return rgb_grey(*(const double *)payload);
}

static void stage_start(struct stage *stage, int levels)
{
    *stage = (struct stage){
        .all = scene_world_new("plane { y, 0 }"),
        .worker = { .scratch = arena_new(0) },
        .fills = memory_new(sizeof *stage->fills),
    };
    stage->mesh = (struct point_mesh){
        .world = stage->all->world,
        .lattice = { .spacing = 0.4 },
        .interpolation = interpolation_find("trilinear"),
        .radius = 1,
        .payload_size = sizeof(double),
        .fill = stage_fill,
        .refinement = { levels, 0.2 },
        .light = stage_view,
        .context = stage,
    };
    lattice_make_finer(&stage->mesh.lattice, levels);
    point_mesh_start(&stage->mesh, 8000000);
}

static void stage_end(struct stage *stage)
{
    point_mesh_free(&stage->mesh);
    memory_free(stage->fills);
    arena_free(stage->worker.scratch);
    scene_world_free(stage->all);
}

static double stage_ask(struct stage *stage, double x, double z)
{
    static struct mesh_blend blend;
    double light = 0, weights = 0;
    arena_reset(stage->worker.scratch);
    const struct receiver receiver = { .point = { x, 0, z },
                                       .side = { 0, 1, 0 },
                                       .weight = 1 };
    point_mesh_blend(&stage->mesh, &stage->worker, &receiver, &blend);
    for (int i = 0; i < blend.count; i++) {
        light += blend.at[i].weight * *(const double *)blend.at[i].payload;
        weights += blend.at[i].weight;
    }
    assert_true(fabs(weights - 1) < 1e-9);
    return light;
}

/* Who asks. */
static const struct lattice_view view;

static void test_nesting(void **state)
{
    const struct lattice lattice = { .spacing = 0.3, .usual = 2 };
    int shared = 0, deep = 0;
    (void)state;
    for (int level = 0; level < 6; level++) {
        for (int i = 0; i < 16 * 16 * 16; i++) {
            struct lattice_point point = {
                level, { i % 16 - 8, i / 16 % 16 - 8, i / 256 - 8 }
            };
            struct lattice_point name = lattice_coarsest(&lattice, &point);
            struct lattice_point again = lattice_coarsest(&lattice, &name);
            vec3 apart = vec3_sub(lattice_place(&lattice, &point),
                                  lattice_place(&lattice, &name));
            assert_true(vec3_length(apart) <
                        1e-12 * lattice_spacing(&lattice, 6));
            assert_memory_equal(&again, &name, sizeof name);
            assert_true(name.level >= level);
            shared += level == 0 && name.level > 0;
            deep += level == 0 && name.level > 1;
        }
    }
    assert_int_equal(shared, 16 * 16 * 16 / 8);
    assert_int_equal(deep, 16 * 16 * 16 / 64);
}

/* Finer levels have points of the coarser ones at their own place. */
static void test_nesting_down(void **state)
{
    const struct lattice lattice = { .spacing = 0.3, .usual = 2 };
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct lattice_point coarse = {
            3, { i % 10 - 5, i / 10 % 10 - 5, i / 100 - 5 }
        };
        vec3 place = lattice_place(&lattice, &coarse);
        vec3 at = lattice_units(&lattice, 0, place);
        struct lattice_point fine = {
            0, { (int)lround(at.x), (int)lround(at.y), (int)lround(at.z) }
        };
        struct lattice_point name = lattice_coarsest(&lattice, &fine);
        struct lattice_point wanted = lattice_coarsest(&lattice, &coarse);
        assert_true(fabs(at.x - fine.at[0]) < 1e-9);
        assert_memory_equal(&name, &wanted, sizeof name);
    }
}

static void test_difference(void **state)
{
    const struct refinement half = { 1, 0.5 };
    struct refine_views views = {
        .count = 2, .at = { { { 1, 1, 1 }, 0.5 }, { { 3, 3, 3 }, 0.5 } }
    };
    (void)state;
    assert_true(fabs(refine_difference(&views) - 1) < 1e-12);
    views.hidden = 0.5;
    assert_true(fabs(refine_difference(&views) - 1.5) < 1e-12);
    views.hidden = 0;
    views.at[1].light = views.at[0].light;
    assert_true(refine_difference(&views) == 0);
    views.at[0].light = views.at[1].light = rgb_grey(0);
    assert_true(refine_difference(&views) == 0);
    assert_true(refine_share(&half, 0.5) == 0);
    assert_true(fabs(refine_share(&half, 0.75) - 0.5) < 1e-12);
    assert_true(refine_share(&half, 1) == 1);
}

static int fills_twice(const struct stage *stage)
{
    const struct fills *fills = stage->fills;
    int twice = 0;
    for (int i = 0; i < fills->count; i++)
        for (int k = 0; k < i; k++) {
            vec3 apart = vec3_sub(fills->at[i], fills->at[k]);
            twice += vec3_length(apart) < 1e-6;
        }
    return twice;
}

static double stage_error(struct stage *stage)
{
    double sum = 0;
    for (double x = -1; x < 1.5; x += 0.01)
        sum += fabs(stage_ask(stage, x, 0.2) -
                    stage_light(stage, vec3_make(x, 0, 0)));
    return sum;
}

static void test_points_are_added(void **state)
{
    static struct stage coarse, fine;
    (void)state;
    stage_start(&coarse, 0);
    stage_start(&fine, 3);
    double before = stage_error(&coarse), after = stage_error(&fine);
    assert_true(after < 0.25 * before);
    assert_int_equal(point_mesh_refined(&coarse.mesh, &view), 0);
    assert_true(point_mesh_refined(&fine.mesh, &view) > 10);
    assert_int_equal(fine.fills->count, table_count(fine.mesh.table));
    assert_int_equal(fills_twice(&fine), 0);
    int known = fine.fills->count;
    assert_true(stage_error(&fine) == after);
    assert_int_equal(fine.fills->count, known);
    stage_end(&coarse);
    stage_end(&fine);
}

/* Where they are asked for at all is where points differ. */
static void test_even_light_needs_none(void **state)
{
    static struct stage stage;
    (void)state;
    stage_start(&stage, 3);
    stage.even = true;
    assert_true(stage_error(&stage) < 1e-9);
    assert_int_equal(point_mesh_refined(&stage.mesh, &view), 0);
    stage_end(&stage);
}

/* A step to the side changes the light by no more than its part of the cell of
 * the finest level, wherever the border of a refined cell is crossed. */
static void test_no_seam(void **state)
{
    static struct stage stage;
    const double step = 1e-4;
    (void)state;
    stage_start(&stage, 2);
    double last = stage_ask(&stage, -0.6, 0), most = 0;
    for (double x = -0.6; x < 1.2; x += step) {
        double now = stage_ask(&stage, x, 0);
        most = fmax(most, fabs(now - last));
        last = now;
    }
    assert_true(point_mesh_refined(&stage.mesh, &view) > 10);
    assert_true(most < 100 * step);
    stage_end(&stage);
}

/* What finds no room in a table is worked out each time, and is the same. */
static void test_full_table(void **state)
{
    static struct stage roomy, full;
    (void)state;
    stage_start(&roomy, 2);
    stage_start(&full, 2);
    point_mesh_free(&full.mesh);
    point_mesh_start(&full.mesh, 3000);
    for (double x = -0.6; x < 1.2; x += 0.07)
        assert_true(stage_ask(&roomy, x, x / 3) == stage_ask(&full, x, x / 3));
    assert_true(table_count(full.mesh.table) <
                table_count(roomy.mesh.table) / 4);
    stage_end(&roomy);
    stage_end(&full);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nesting),
        cmocka_unit_test(test_nesting_down),
        cmocka_unit_test(test_difference),
        cmocka_unit_test(test_points_are_added),
        cmocka_unit_test(test_even_light_needs_none),
        cmocka_unit_test(test_no_seam),
        cmocka_unit_test(test_full_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
