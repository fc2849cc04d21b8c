/* Lights in one place are one light, unless they differ in more than colour. */
#include "harness.h"

#include "scene_world.h"

static size_t lights_of(const char *text, rgb *first)
{
    struct scene_world *all = scene_world_new(text);
    size_t count;
    const struct light *lights = world_lights(all->world, &count);
    *first = lights[0].colour;
    scene_world_free(all);
    return count;
}

static void test_same(void **state)
{
    rgb first;
    (void)state;
    assert_int_equal(
        lights_of("#declare I = 0; #while (I < 100) light_source { <1, 2, 3>, "
                  "rgb <0.01, 0.02, 0> } #declare I = I + 1; #end "
                  "union { light_source { 0, rgb <0, 0, 5> } "
                  "translate <1, 2, 3> }",
                  &first),
        1);
    assert_true(fabs(first.r - 1) < 1e-12 && fabs(first.g - 2) < 1e-12 &&
                fabs(first.b - 5) < 1e-12);
}

/* Turned into their places, or set a trifle apart. */
static void test_nearly_same(void **state)
{
    rgb first;
    (void)state;
    assert_int_equal(
        lights_of("#declare I = 0; #while (I < 100) light_source { x, "
                  "rgb 0.01 rotate 3.6 * I * y rotate -3.6 * I * y "
                  "translate <3, 0, 4> + 1e-9 * I * x } "
                  "#declare I = I + 1; #end",
                  &first),
        1);
    assert_true(fabs(first.g - 1) < 1e-12);
    assert_int_equal(
        lights_of("#declare I = 0; #while (I < 10) light_source { "
                  "<4e6, 0, 1e-5 * I>, rgb 1 } light_source { "
                  "<4e6 + 0.01 * I, 0, 1>, rgb 1 } #declare I = I + 1; #end",
                  &first),
        20);
}

static void test_different(void **state)
{
    rgb first;
    (void)state;
    assert_int_equal(
        lights_of("#macro L() light_source { <1, 2, 3>, rgb 0.5 #end "
                  "L() } L() shadowless } L() spotlight point_at 0 } "
                  "L() spotlight point_at 0 radius 20 } L() fade_distance 2 "
                  "fade_power 2 } L() area_light x, y, 3, 3 } "
                  "L() area_light x, y, 3, 3 jitter } L() parallel } "
                  "L() photons { refraction on } } "
                  "L() looks_like { sphere { 0, 0.1 } } } "
                  "L() looks_like { sphere { 0, 0.1 } } } "
                  "light_source { <1, 2, 3.001>, rgb 0.5 }",
                  &first),
        12);
    assert_true(first.r == 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same),
        cmocka_unit_test(test_nearly_same),
        cmocka_unit_test(test_different),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
