/* A lit patch as virtual lights: all of its light, once. */
#include "harness.h"

#include "base/side.h"
#include "base/warp.h"
#include "lightmesh/gather_virtual.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/virtual_lights.h"
#include "scene_world.h"

/* A lamp of parallel rays lights a disc of radius .8 on a floor. */
#define LIT                                                                    \
    "camera { location <0, 2, 0> look_at 0 } "                                 \
    "light_source { <0, 1, 0>, rgb 5 cylinder radius .8 falloff .8001 "        \
    "tightness 0 point_at 0 parallel } "                                       \
    "plane { y, 0 pigment { rgb <.8, .4, .2> } finish { ambient 0 diffuse 1 }" \
    " } "

static const double radius = 0.8;

struct patch {
    struct scene_world *all;
    struct lamps lamps;
    struct worker worker;
    struct virtual_lights *lights;
    int picks;
};

/* The cell that its middle is in. */
static const struct virtual_cell *patch_cell(const struct patch *patch)
{
    const vec3 middle = { 0, 0, 0 }, up = { 0, 1, 0 };
    uint64_t key = cell_key(middle, side_of(up), patch->lights->side);
    for (int i = 0; i < VIRTUAL_SLOTS; i++)
        if (patch->lights->cell[i].key == key)
            return &patch->lights->cell[i];
    fail_msg("no cell");
    return NULL;
}

/* Cells of side 1: the patch is in four of them. */
static struct patch patch_new(const char *text, double worth, int times)
{
    struct bright lit = { .count = 4, .radius = 0.7 };
    struct patch patch = { .all = scene_world_new(text) };
    for (int i = 0; i < 4; i++)
        lit.at[i] = (struct bright_disc){
            { i % 2 - 0.5, 0, i / 2 - 0.5 }, { 0, 1, 0 }, worth, 0.25
        };
    patch.lamps = lamps_new(patch.all->world, patch.all->scene, 9, 0);
    patch.worker = (struct worker){ .scratch = arena_new(0) };
    patch.lights = virtual_lights_new(&lit, &patch.lamps, times, &patch.worker);
    patch.picks = VIRTUAL_PICKS_USUAL;
    return patch;
}

static void patch_free(struct patch *patch)
{
    virtual_lights_free(patch->lights);
    arena_free(patch->worker.scratch);
    lamps_free(&patch->lamps);
    scene_world_free(patch->all);
}

/* Irradiance of a place that looks down, by all parts together. */
static rgb patch_gives(struct patch *patch, vec3 place)
{
    const struct gather gather = { .lamps = &patch->lamps,
                                   .virtual_lights = patch->lights,
                                   .picks = patch->picks };
    struct gathered_glow found[VIRTUAL_PICKS_MOST];
    rgb sum = rgb_grey(0);
    for (unsigned part = 0; part < GATHER_PARTS; part++) {
        unsigned count =
            gather_virtual(&gather, &patch->worker, place, part, found);
        for (unsigned i = 0; i < count; i++)
            sum =
                rgb_add_scaled(sum, found[i].light,
                               -found[i].direction.y /
                                   (WARP_PI * found[i].density * GATHER_PARTS));
    }
    return sum;
}

/* What a place so high, and so far beside the axis, sees of the disc. */
static double seen_share(double height, double beside)
{
    double h = height * height, a = beside * beside, r = radius * radius;
    double root = sqrt((h + a + r) * (h + a + r) - 4 * a * r);
    return (1 - (h + a - r) / root) / 2;
}

static void assert_about(double value, double wanted)
{
    if (!(fabs(value - wanted) <= 0.01 * fabs(wanted)))
        fail_msg("%g, not %g", value, wanted);
}

static void all_light(int times)
{
    struct patch patch = patch_new(LIT, 1, times);
    assert_true(patch.lights->count > 0 && patch_cell(&patch)->near < 1);
    for (double height = 2; height <= 4; height++)
        for (double beside = 0; beside <= 3; beside++) {
            vec3 place = { beside * 0.6, height, -beside * 0.8 };
            double wanted = 4 * seen_share(height, beside);
            rgb light = patch_gives(&patch, place);
            assert_about(light.r, wanted);
            assert_about(light.g, wanted / 2);
            assert_about(light.b, wanted / 4);
        }
    patch_free(&patch);
}

static void test_all_light(void **state)
{
    (void)state;
    all_light(1);
    all_light(4);
}

/* What they bring and what gather rays are left with is all. */
static void test_shares(void **state)
{
    const vec3 up = { 0, 1, 0 }, down = { 0, -1, 0 }, middle = { 0, 0, 0 };
    struct patch patch = patch_new(LIT, 0.5, 1);
    const struct virtual_lights *lights = patch.lights;
    (void)state;
    const double near = patch_cell(&patch)->near;
    assert_true(virtual_lights_share(lights, middle, up, near) == 0);
    assert_true(virtual_lights_share(lights, middle, up, 2 * near) == 0.5);
    assert_true(virtual_lights_share(lights, middle, down, 9) == 0);
    assert_true(virtual_lights_share(lights, vec3_make(9, 0, 9), up, 9) == 0);
    assert_about(patch_gives(&patch, vec3_make(0, 3, 0)).r,
                 0.5 * 4 * seen_share(3, 0));
    patch_free(&patch);
}

/* Few that are picked bring what all do; none that faces away is. */
static void picks_some(int times)
{
    struct patch patch = patch_new(LIT, 1, times);
    struct virtual_pick picks[VIRTUAL_PICKS_MOST];
    patch.picks = 32;
    for (double beside = 0; beside <= 3; beside++) {
        vec3 place = { beside, 2, 0 };
        double wanted = 4 * seen_share(2, beside);
        double light = patch_gives(&patch, place).r;
        int count = virtual_lights_pick(patch.lights, place, 0, 32, picks);
        assert_true(abs(count - 32) < 8);
        assert_true(fabs(light - wanted) < 0.04 * wanted);
    }
    assert_int_equal(
        virtual_lights_pick(patch.lights, vec3_make(0, -2, 0), 0, 32, picks),
        0);
    patch_free(&patch);
}

static void test_picks(void **state)
{
    (void)state;
    picks_some(1);
    picks_some(4);
}

/* Where a quarter of the disc gets dark, what is picked of the others stays,
 * but that there are more of these. */
static void test_stays(void **state)
{
    struct patch before = patch_new(LIT, 1, 4);
    struct patch after = patch_new(LIT "box { <0, .9, 0>, 1 }", 1, 4);
    struct virtual_pick old[VIRTUAL_PICKS_MOST], new[VIRTUAL_PICKS_MOST];
    const vec3 place = { 0, 0.8, -3 };
    (void)state;
    for (unsigned part = 0; part < GATHER_PARTS; part++) {
        int n = virtual_lights_pick(before.lights, place, part, 64, old);
        int m = virtual_lights_pick(after.lights, place, part, 64, new);
        int still = 0, same = 0;
        for (int i = 0; i < n; i++) {
            vec3 at = old[i].light->point;
            still += at.x < 0 || at.z < 0;
            for (int k = 0; k < m; k++)
                same += vec3_length(vec3_sub(at, new[k].light->point)) < 1e-9;
        }
        assert_true(still > 0 && same >= still);
    }
    patch_free(&before);
    patch_free(&after);
}

/* A lamp may take light away, and one colour alone. */
static void test_negative(void **state)
{
    struct patch patch = patch_new(
        LIT "light_source { <0, 1, 0>, rgb <-6, 0, 2> cylinder radius .8 "
            "falloff .8001 tightness 0 point_at 0 parallel } ",
        1, 1);
    double share = seen_share(3, 0);
    rgb light = patch_gives(&patch, vec3_make(0, 3, 0));
    (void)state;
    assert_about(light.r, -0.8 * share);
    assert_about(light.g, 2 * share);
    assert_about(light.b, 1.4 * share);
    patch_free(&patch);
}

static void test_hidden(void **state)
{
    struct patch patch =
        patch_new(LIT "box { <-9, 1.5, -9>, <9, 1.6, 9> }", 1, 1);
    struct patch dark = patch_new("camera { location <0, 2, 0> look_at 0 } "
                                  "plane { y, 0 pigment { rgb 1 } }",
                                  1, 1);
    (void)state;
    assert_true(patch_gives(&patch, vec3_make(0, 3, 0)).r == 0);
    assert_true(patch_gives(&patch, vec3_make(0, 1.4, 0)).r > 0);
    assert_int_equal(dark.lights->count, 0);
    patch_free(&patch);
    patch_free(&dark);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_light), cmocka_unit_test(test_shares),
        cmocka_unit_test(test_picks),     cmocka_unit_test(test_negative),
        cmocka_unit_test(test_hidden),    cmocka_unit_test(test_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
