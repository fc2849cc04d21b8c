/* The functions of Julia sets: bounds hold, slopes are the values' own. */
#include "harness.h"

#include <math.h>

#include "base/random.h"
#include "scene/julia_function.h"

static double draw(uint64_t key, double from, double to)
{
    return from + (to - from) * random_unit(random_mix(key));
}

static double complex place(uint64_t key)
{
    return CMPLX(draw(3 * key, -2, 2), draw(3 * key + 1, -2, 2));
}

/* Nothing at most e away has a value farther off than that. */
static void spreads_are_bounds(void **state)
{
    (void)state;
    const double complex power = CMPLX(1.5, -0.4);
    const struct julia_function *f;
    for (int i = 0; (f = julia_function_at(i)); i++) {
        int bounded = 0;
        for (uint64_t k = 0; k < 2000; k++) {
            double complex z = place(k);
            double e = draw(3 * k + 2, 0, 0.4);
            double most = f->spread(z, e, power);
            if (!isfinite(most))
                continue;
            bounded++;
            for (int turn = 0; turn < 12; turn++) {
                double complex h = e * cexp(CMPLX(0, turn * 3.14159265 / 6));
                double off = cabs(f->value(z + h, power) - f->value(z, power));
                assert_true(off <= most * (1 + 1e-9) + 1e-12);
            }
        }
        assert_true(bounded > 500);
    }
}

static void slopes_are_derivatives(void **state)
{
    (void)state;
    const double complex power = CMPLX(1.5, -0.4);
    const double small = 1e-6;
    const struct julia_function *f;
    for (int i = 0; (f = julia_function_at(i)); i++)
        for (uint64_t k = 0; k < 200; k++) {
            double complex z = place(k + 7000);
            if (!isfinite(f->spread(z, 0.05, power)))
                continue;
            double complex slope =
                (f->value(z + small, power) - f->value(z - small, power)) /
                (2 * small);
            double complex said = f->slope(z, power);
            assert_true(cabs(slope - said) <= 1e-4 * (1 + cabs(said)));
        }
}

/* Eight at once are as one, on both sides of the cuts, near 0 and far off. */
static void octets_are_values(void **state)
{
    (void)state;
    const double power[2] = { 1.5, -0.4 };
    const struct julia_function *f;
    for (int i = 0; (f = julia_function_at(i)); i++)
        for (uint64_t k = 0; k < 400; k++) {
            struct complex_octet z;
            double complex one[OCTET];
            for (int lane = 0; lane < OCTET; lane++) {
                one[lane] = place(k * OCTET + lane + 9000) * (k % 4 == 0 ? 1e-3
                                                              : k % 4 == 1 ? 2.8
                                                                           : 1);
                z.re[lane] = creal(one[lane]);
                z.im[lane] = cimag(one[lane]);
            }
            f->octets(&z, power);
            for (int lane = 0; lane < OCTET; lane++) {
                double complex value =
                    f->value(one[lane], CMPLX(power[0], power[1]));
                double off = cabs(CMPLX(z.re[lane], z.im[lane]) - value);
                assert_true(off <= 1e-12 * (1 + cabs(value)));
            }
        }
}

static void names_are_found(void **state)
{
    (void)state;
    assert_ptr_equal(julia_function_find("sqr"), julia_function_at(0));
    assert_null(julia_function_find("abs"));
    assert_null(julia_function_at(100));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spreads_are_bounds),
        cmocka_unit_test(slopes_are_derivatives),
        cmocka_unit_test(octets_are_values),
        cmocka_unit_test(names_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
