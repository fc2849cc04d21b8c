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
        cmocka_unit_test(names_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
