/* Functions at several points at once: the values are those of each point. */
#include "harness.h"

#include "scene/function.h"
#include "scene/spots.h"

static double product_value(const struct function_field *field, vec3 point)
{
    (void)field;
    return point.x * point.y * point.z;
}

static void product_values(const struct function_field *field,
                           const struct spots *spots, double *values)
{
    for (int i = 0; i < spots->count; i++)
        values[i] = product_value(field, spots_at(spots, i));
}

static const struct function_field product = { product_value, product_values,
                                               NULL, 0 };

static struct function function_of(struct step *steps, size_t count)
{
    struct function f = { .parameter_count = 3,
                          .slots = 3,
                          .height = 6,
                          .work = (double)count,
                          .steps = { steps, count, count } };
    f.even = function_is_even(&f);
    return f;
}

static void check_points(const struct function *function)
{
    assert_true(function->even);
    for (int i = 0; i < 200; i++) {
        struct spots spots = { 0 };
        double values[SPOTS_MAX];
        for (int k = 0; k <= i % SPOTS_MAX; k++)
            spots_add(&spots, vec3_make(i % 5 - 2, sin(i + k), k - i * 0.01));
        function_values_at(function, &spots, values);
        for (int k = 0; k < spots.count; k++)
            assert_true(values[k] ==
                        function_at(function, spots_at(&spots, k)));
    }
}

/* -(x / (y + 2)) * z - 3 */
static struct step operators[] = {
    { .kind = STEP_LOCAL, .slot = 0 },
    { .kind = STEP_LOCAL, .slot = 1 },
    { .kind = STEP_PLUS_NUMBER, .number = 2 },
    { .kind = STEP_OVER },
    { .kind = STEP_NEGATE },
    { .kind = STEP_TIMES_LOCAL, .slot = 2 },
    { .kind = STEP_MINUS_NUMBER, .number = 3 },
};

static void operators_are_even(void **state)
{
    (void)state;
    struct function f = function_of(operators, 7);
    check_points(&f);
}

/* y + select(x, z, 2, f(z, 1, x)) - product(x, y, y) */
static void calls_are_even(void **state)
{
    (void)state;
    struct function called = function_of(operators, 7);
    struct step steps[] = {
        { .kind = STEP_LOCAL, .slot = 1 },
        { .kind = STEP_LOCAL, .slot = 0 },
        { .kind = STEP_LOCAL, .slot = 2 },
        { .kind = STEP_NUMBER, .number = 2 },
        { .kind = STEP_LOCAL, .slot = 2 },
        { .kind = STEP_NUMBER, .number = 1 },
        { .kind = STEP_LOCAL, .slot = 0 },
        { .kind = STEP_CALL, .function = &called },
        { .kind = STEP_SELECT, .slot = 4 },
        { .kind = STEP_PLUS },
        { .kind = STEP_LOCAL, .slot = 0 },
        { .kind = STEP_LOCAL, .slot = 1 },
        { .kind = STEP_LOCAL, .slot = 1 },
        { .kind = STEP_FIELD, .field = &product },
        { .kind = STEP_MINUS },
    };
    struct function f = function_of(steps, 15);
    f.height = 16;
    check_points(&f);
}

/* x / y - x / y: infinite less infinite is no number */
static void what_is_no_number_is_zero(void **state)
{
    (void)state;
    struct step steps[] = {
        { .kind = STEP_LOCAL, .slot = 0 },
        { .kind = STEP_OVER_LOCAL, .slot = 1 },
        { .kind = STEP_LOCAL, .slot = 0 },
        { .kind = STEP_OVER_LOCAL, .slot = 1 },
        { .kind = STEP_MINUS },
    };
    struct function f = function_of(steps, 5);
    struct spots spots = { 2, { 1, 1 }, { 0, 1 }, { 0, 0 } };
    double values[2] = { 1, 1 };
    function_values_at(&f, &spots, values);
    assert_true(values[0] == 0 && values[1] == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operators_are_even),
        cmocka_unit_test(calls_are_even),
        cmocka_unit_test(what_is_no_number_is_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
