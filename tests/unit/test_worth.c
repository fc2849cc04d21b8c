/* What the picture shows little of: it uses coarser mesh points, or none. */
#include "harness.h"

#include "lightmesh/indirect.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/table.h"
#include "scene_world.h"

struct stage {
    struct scene_world *all;
    struct worker worker;
    struct indirect_mesh mesh;
    struct lattice_view view;
};

static void stage_fill(const void *context, struct worker *worker,
                       const struct mesh_site *site, void *payload)
{
    (void)context;
    (void)worker;
    ((struct harmonics *)payload)->r[0] = site->lone ? 3 : 2;
}

static bool stage_close(const void *context, struct worker *worker, vec3 place,
                        vec3 normal, vec3 from, rgb *light)
{
    (void)context;
    (void)worker;
    (void)place;
    (void)normal;
    (void)from;
    *light = rgb_grey(1);
    return true;
}

static void stage_start(struct stage *stage, const char *text, int coarser)
{
    *stage = (struct stage){
        .all = scene_world_new(text),
        .worker = { .scratch = arena_new(0) },
    };
    stage->view.coarser = coarser;
    stage->mesh.gather.close = stage_close;
    stage->mesh.points = (struct point_mesh){
        .world = stage->all->world,
        .lattice = { .spacing = 0.4 },
        .interpolation = interpolation_find("trilinear"),
        .radius = 1,
        .payload_size = sizeof(struct indirect_light),
        .fill = stage_fill,
        .context = stage,
    };
    point_mesh_start(&stage->mesh.points, 8000000);
}

static void stage_end(struct stage *stage)
{
    point_mesh_free(&stage->mesh.points);
    arena_free(stage->worker.scratch);
    scene_world_free(stage->all);
}

/* How many points a floor of 6 x 6 asks for. */
static size_t stage_ask(struct stage *stage, double worth)
{
    for (int i = 0; i < 900; i++) {
        vec3 up = { 0, 1, 0 };
        const struct receiver place = {
            .point = vec3_make(i % 30 / 5.0, 0, i / 30 / 5.0),
            .side = up,
            .normal = up,
            .from = vec3_make(0, 9, 0),
            .view = stage->view,
            .weight = worth,
        };
        indirect_mesh_light(&stage->mesh, &stage->worker, &place);
        arena_reset(stage->worker.scratch);
    }
    return table_count(stage->mesh.points.table);
}

static size_t points_asked(const char *text, int coarser, double worth,
                           unsigned long long *lone)
{
    struct stage stage;
    stage_start(&stage, text, coarser);
    size_t count = stage_ask(&stage, worth);
    *lone = atomic_load(&stage.mesh.points.work->lone);
    stage_end(&stage);
    return count;
}

static void test_levels(void **state)
{
    unsigned long long lone;
    const char *floor = "plane { y, 0 }";
    (void)state;
    size_t whole = points_asked(floor, 0, 1, &lone);
    size_t little = points_asked(floor, 0, 0.12, &lone);
    size_t least = points_asked(floor, 0, 0.04, &lone);
    assert_true(whole > 200);
    /* dark paint, as of half of a floor's squares: no mesh of its own */
    assert_int_equal(points_asked(floor, 0, 0.2, &lone), whole);
    assert_true(little < whole);
    assert_true(least < little / 2 && least > 0);
    assert_int_equal(points_asked(floor, 1, 1, &lone), little);
    assert_int_equal(points_asked(floor, 0, 0.01, &lone), 0);
    assert_int_equal(lone, 0);
}

/* A gap so low that coarse levels have no point in it, but the finest has. */
static void test_gap(void **state)
{
    unsigned long long lone;
    const char *gap = "plane { y, 0 } plane { y, 0.42 }";
    (void)state;
    assert_true(points_asked(gap, 0, 1, &lone) > 0);
    assert_int_equal(lone, 0);
    assert_true(points_asked(gap, 0, 0.03, &lone) > 0);
    assert_int_equal(lone, 0);
    assert_true(points_asked(gap, 2, 1, &lone) > 0);
    assert_int_equal(lone, 0);
}

static void test_unknown_void(void **state)
{
    struct stage stage;
    vec3 up = { 0, 1, 0 };
    const struct receiver place = { .point = { 0.3, 0, 0.2 },
                                    .side = up,
                                    .normal = up,
                                    .from = { 0, 9, 0 },
                                    .weight = 0.01 };
    (void)state;
    stage_start(&stage, "plane { y, 0 }", 0);
    rgb light = indirect_mesh_light(&stage.mesh, &stage.worker, &place).light;
    assert_true(light.r == 1 && light.b == 1);
    stage.mesh.gather.close = NULL;
    light = indirect_mesh_light(&stage.mesh, &stage.worker, &place).light;
    assert_true(light.r > 1 && light.b == 0);
    stage_end(&stage);
}

/* As even as so few can be: their mean is that of the cosine, and each packet
 * of many has it. */
static void test_near_ways(void **state)
{
    const int counts[] = { 5, 10, 64 };
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct near_ways ways = near_ways_new(counts[i]);
        assert_int_equal(ways.count, counts[i]);
        for (int first = 0; first < ways.count; first += RAY_LANES) {
            int end = first + RAY_LANES;
            end = end < ways.count ? end : ways.count;
            vec3 sum = { 0, 0, 0 };
            for (int k = first; k < end; k++) {
                assert_true(fabs(vec3_length(ways.ways[k]) - 1) < 1e-9);
                sum = vec3_add(sum, ways.ways[k]);
            }
            sum = vec3_scale(sum, 1.0 / (end - first));
            assert_true(fabs(sum.x) < 0.16 && fabs(sum.y) < 0.16);
            assert_true(fabs(sum.z - 2.0 / 3) < 0.04);
        }
        near_ways_free(&ways);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_levels),
        cmocka_unit_test(test_gap),
        cmocka_unit_test(test_unknown_void),
        cmocka_unit_test(test_near_ways),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
