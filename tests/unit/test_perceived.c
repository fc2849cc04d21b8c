/* What the table of antialiasing decides is what pow() would decide. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "base/random.h"
#include "render/perceived.h"

static double power(float value, double exponent)
{
    return value > 0 ? pow((double)value, exponent) : 0;
}

static double exact_sum(const float *a, const float *b, double exponent)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i])
            sum += fabs(power(a[i], exponent) - power(b[i], exponent));
    return sum;
}

/* From very dark to very bright, some below 0. */
static float random_light(uint64_t key)
{
    double size = 40 * random_unit(random_key(key, 1)) - 30;
    double light = exp(size / (1 + key % 5));
    return (float)(key % 11 == 0 ? -light : light);
}

static void check(const struct perceived *table, const float *a, const float *b)
{
    double sum = exact_sum(a, b, table->exponent);
    const double thresholds[] = { 0,
                                  0.3,
                                  sum,
                                  nextafter(sum, 0),
                                  nextafter(sum, 1e300),
                                  sum * (1 - 1e-6),
                                  sum * (1 + 1e-6),
                                  sum * 0.99,
                                  sum * 1.01 };
    for (unsigned i = 0; i < sizeof thresholds / sizeof thresholds[0]; i++)
        assert_int_equal(perceived_differ(table, a, b, 0, thresholds[i]),
                         sum >= thresholds[i]);
    assert_int_equal(perceived_differ(table, a, b, 0.2, 0.5), sum + 0.2 >= 0.5);
}

static void test_exact(void **state)
{
    const double exponents[] = { 1, 0.4, 1 / 2.2, 0.1, 2, 3.7, 5 };
    (void)state;
    for (unsigned k = 0; k < sizeof exponents / sizeof exponents[0]; k++) {
        struct perceived table;
        perceived_fill(&table, exponents[k]);
        for (uint64_t n = 0; n < 20000; n++) {
            float a[3], b[3];
            for (uint64_t i = 0; i < 3; i++) {
                a[i] = random_light(random_key(n, i));
                b[i] = n % 3 == i ? a[i] : random_light(random_key(n, i + 7));
                if (n % 2)
                    b[i] = a[i] * (1 + 1e-3F * (float)i);
            }
            check(&table, a, b);
        }
    }
}

static void test_not_numbers(void **state)
{
    const float odd[3] = { NAN, INFINITY, -INFINITY };
    const float plain[3] = { 0.5F, 0.5F, 1e-45F };
    struct perceived table;
    (void)state;
    perceived_fill(&table, 0.4);
    check(&table, odd, plain);
    check(&table, plain, plain);
}

/* Light of 0.5 in sRGB is 0.2140411, of 0.02 a 12.92th. */
static void test_srgb(void **state)
{
    const float bright[3] = { 0.5F, 0, 0 }, dark[3] = { 0.02F, 0, 0 };
    const double apart = pow(0.2140411, 0.4) - pow(0.02 / 12.92, 0.4);
    struct perceived table;
    (void)state;
    perceived_fill_srgb(&table, 0.4);
    assert_true(perceived_differ(&table, bright, dark, 0, apart - 1e-6));
    assert_false(perceived_differ(&table, bright, dark, 0, apart + 1e-6));
    assert_true(perceived_differ(&table, dark, dark, 0, 0));
    assert_false(perceived_differ(&table, dark, dark, 0, 1e-9));
}

/* A row leaves out none that differs, and most that do not. */
static void test_rows(void **state)
{
    float a[PERCEIVED_ROW][4], b[PERCEIVED_ROW][4];
    struct perceived table;
    unsigned unsure = 0;
    (void)state;
    perceived_fill(&table, 0.4);
    for (uint64_t n = 0; n < 500; n++) {
        const struct perceived_limit limit = { n % 2 ? 1 : 0, 0.3 };
        for (uint64_t i = 0; i < PERCEIVED_ROW; i++)
            for (uint64_t k = 0; k < 4; k++) {
                a[i][k] = random_light(random_key(n, 4 * i + k));
                b[i][k] = i % 4 ? a[i][k] * (1 + 1e-3F * (float)k)
                                : random_light(random_key(n + 500, 4 * i + k));
            }
        uint32_t bits = perceived_may_differ(&table, (const float(*)[4])a,
                                             (const float(*)[4])b, limit);
        for (unsigned i = 0; i < PERCEIVED_ROW; i++) {
            double apart = limit.opacity * fabs((double)(a[i][3] - b[i][3]));
            bool differ = perceived_differ(&table, a[i], b[i], apart, 0.3);
            assert_true(!differ || bits >> i & 1);
            unsure += !differ && bits >> i & 1;
        }
    }
    assert_true(unsure < 500 * PERCEIVED_ROW / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),
        cmocka_unit_test(test_not_numbers),
        cmocka_unit_test(test_srgb),
        cmocka_unit_test(test_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
