/* Functions at several points at once: the values are those of each point. */
#include "harness.h"

#include "base/octet_math.h"
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
    function_join(&f);
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

static struct step built_in(enum step_kind kind)
{
    return (struct step){ .kind = kind };
}

/* sqrt(abs(atan2(sin(x), cos(y)))) + y^2 - z^3 * x^4 + (x min z) + ... */
static void built_in_functions_are_even(void **state)
{
    (void)state;
    struct step local[3] = { { .kind = STEP_LOCAL, .slot = 0 },
                             { .kind = STEP_LOCAL, .slot = 1 },
                             { .kind = STEP_LOCAL, .slot = 2 } };
    struct step sine = built_in(STEP_ONE), cosine = sine, root = sine,
                size = sine, power[3] = { sine, sine, sine };
    struct step arc = built_in(STEP_TWO), least = arc;
    step_set_one(&sine, sin);
    step_set_one(&cosine, cos);
    step_set_one(&root, sqrt);
    step_set_one(&size, fabs);
    step_set_two(&arc, atan2);
    step_set_two(&least, fmin);
    for (int i = 0; i < 3; i++)
        assert_true(step_set_power(&power[i], i + 2));
    assert_false(step_set_power(&power[0], 2.5));
    struct step plus = built_in(STEP_PLUS), minus = built_in(STEP_MINUS);
    struct step steps[] = { local[0], sine,     local[1], cosine,   arc,
                            size,     root,     local[1], power[0], plus,
                            local[2], power[1], local[0], power[2], minus,
                            minus,    local[0], local[2], least,    plus };
    struct function f = function_of(steps, 20);
    check_points(&f);
    double x = 0.7, y = -2.1, z = 1.3;
    double value = sqrt(fabs(atan2(sin(x), cos(y)))) + y * y -
                   (z * z * z - x * x * x * x) + x;
    assert_true(fabs(function_at(&f, vec3_make(x, y, z)) - value) < 1e-14);
}

/* What is done number by number, mostly, is not worked out ahead. */
static void costly_functions_are_not_even(void **state)
{
    (void)state;
    struct step steps[] = { { .kind = STEP_LOCAL }, { .kind = STEP_ONE } };
    step_set_one(&steps[1], exp);
    assert_false(function_of(steps, 2).even);
    step_set_one(&steps[1], sin);
    assert_true(function_of(steps, 2).even);
}

static double many_value(const double *a)
{
    return a[0] * exp(a[1]) - a[2];
}

/* What is done point by point can be a part of what is done at once. */
static void internal_functions_go_along(void **state)
{
    (void)state;
    struct step steps[16] = { { .kind = STEP_LOCAL, .slot = 0 },
                              { .kind = STEP_LOCAL, .slot = 1 },
                              { .kind = STEP_LOCAL, .slot = 2 },
                              { .kind = STEP_MANY, .slot = 3 } };
    steps[3].many = many_value;
    assert_false(function_of(steps, 4).even);
    assert_true(function_of(steps, 4).together);
    for (int i = 4; i < 16; i++)
        steps[i] = (struct step){ .kind = STEP_PLUS_NUMBER, .number = 0.1 * i };
    struct function f = function_of(steps, 16);
    f.even = true;
    check_points(&f);
}

static void check_near(double found, double wanted)
{
    assert_true(fabs(found - wanted) <= 1e-15 * fmax(1, fabs(wanted)) ||
                (isnan(found) && isnan(wanted)));
}

static const double ends[] = {
    0, -0.0, 1e-310, 1e300, 1, (double)INFINITY, -(double)INFINITY, (double)NAN
};

/* At angles of all sizes, at the axes and beyond all numbers. */
static void angles_are_as_the_library_has_them(void **state)
{
    (void)state;
    for (int i = -2000; i <= 2000; i++) {
        double x = i * fabs((double)i) * 0.7, y = 3 - i * 0.001;
        check_near(lone_sin(x), sin(x));
        check_near(lone_cos(y), cos(y));
        check_near(lone_atan2(y, x), atan2(y, x));
        check_near(lone_sin(x * 35), sin(x * 35));
        check_near(lone_cos(x * 36), cos(x * 36));
    }
    for (int i = 0; i < 64; i++) {
        double y = ends[i / 8], x = ends[i % 8];
        check_near(lone_atan2(y, x), atan2(y, x));
        check_near(lone_sin(x), sin(x));
        check_near(lone_cos(x), cos(x));
    }
}

static bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static void check_octet(octet y, octet x)
{
    octet sine = x, cosine = x, arc = y, root = x;
    octet_sin(&sine);
    octet_cos(&cosine);
    octet_atan2(&arc, &x);
    octet_sqrt(&root);
    for (int i = 0; i < OCTET; i++) {
        assert_true(same(sine[i], lone_sin(x[i])));
        assert_true(same(cosine[i], lone_cos(x[i])));
        assert_true(same(arc[i], lone_atan2(y[i], x[i])));
        assert_true(same(root[i], sqrt(x[i])));
    }
}

/* Within some last bits. */
static void check_close(double is, double should_be)
{
    assert_true(fabs(is - should_be) <= 1e-15 * fabs(should_be));
}

static void powers_are_as_the_library_has_them(void **state)
{
    (void)state;
    for (int i = -2000; i <= 2000; i++) {
        octet power, logarithm;
        double x[OCTET], y[OCTET];
        for (int k = 0; k < OCTET; k++) {
            x[k] = (i + k * 0.1) * (k % 2 ? 0.001 : 0.35);
            y[k] = k % 2 ? 2 + i * 0.0009 : exp(x[k] * 0.95);
            power[k] = x[k];
            logarithm[k] = y[k];
        }
        octet_exp(&power);
        octet_ln(&logarithm);
        for (int k = 0; k < OCTET; k++) {
            check_close(power[k], exp(x[k]));
            check_close(logarithm[k], log(y[k]));
        }
    }
    octet ends_of = { -1000, 1000, 0, 0, 0, 0, 0, 0 };
    octet_exp(&ends_of);
    assert_true(ends_of[0] >= 0 && ends_of[0] < 1e-300);
    assert_true(ends_of[1] > 1e300);
    assert_true(ends_of[2] == 1);
    octet_ln(&ends_of);
    assert_true(ends_of[2] == 0);
}

static void octets_are_as_single_numbers(void **state)
{
    octet x = { 0 }, y = x;
    (void)state;
    for (int i = -500; i <= 500; i++) {
        for (int k = 0; k < OCTET; k++) {
            x[k] = i * fabs((double)i) * 0.7 + k;
            y[k] = 3 - i * 0.001 * (k - 3);
        }
        check_octet(y, x);
        check_octet(x, y);
        x[i & 7] = ends[i >> 3 & 7];
        check_octet(y, x);
    }
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
        cmocka_unit_test(built_in_functions_are_even),
        cmocka_unit_test(costly_functions_are_not_even),
        cmocka_unit_test(internal_functions_go_along),
        cmocka_unit_test(angles_are_as_the_library_has_them),
        cmocka_unit_test(octets_are_as_single_numbers),
        cmocka_unit_test(powers_are_as_the_library_has_them),
        cmocka_unit_test(what_is_no_number_is_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
