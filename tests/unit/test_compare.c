/* FLIP, SSIM and the sums against cases worked out by hand. The numbers for
 * coloured and for shifted pictures come from another program, a script that
 * convolves with the papers' two-dimensional kernels directly. */
#include "harness.h"

#include <math.h>

#include "compare/figures.h"
#include "compare/flip.h"
#include "compare/heat.h"
#include "compare/ssim.h"
#include "image/ramp.h"

static struct image *image_of(int width, int height, double r, double g,
                              double b)
{
    struct image *image = image_new(width, height);
    for (int i = 0; i < width * height; i++) {
        float *pixel = image->pixels + 4 * i;
        pixel[0] = (float)r;
        pixel[1] = (float)g;
        pixel[2] = (float)b;
        pixel[3] = 1;
    }
    return image;
}

static double flip_mean_of(const struct pair *pair, double pixels_per_degree)
{
    struct plane map = flip_map(pair, pixels_per_degree);
    double mean = plane_mean(&map, 0);
    plane_free(&map);
    return mean;
}

/* Nothing to blur and no features: the colour difference alone, which is 1
 * between pure green and pure blue. */
static void flip_of_even_pictures(void **state)
{
    (void)state;
    static const struct {
        double a[3], b[3], flip;
    } cases[] = {
        { { 0, 0, 0 }, { 1, 1, 1 }, 0.9673792 },
        { { 0.5, 0.5, 0.5 }, { 0.6, 0.6, 0.6 }, 0.2850097 },
        { { 1, 0, 0 }, { 0, 1, 0 }, 0.9866614 },
        { { 0, 1, 0 }, { 0, 0, 1 }, 1 },
        { { 0.2, 0.4, 0.6 }, { 0.3, 0.35, 0.5 }, 0.2688913 },
        { { 0.2, 0.4, 0.6 }, { 0.2, 0.4, 0.6 }, 0 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *a = cases[i].a, *b = cases[i].b;
        struct pair pair =
            pair_new(image_of(9, 7, a[0], a[1], a[2]),
                     image_of(9, 7, b[0], b[1], b[2]), SPACE_DISPLAY);
        assert_float_equal(flip_mean_of(&pair, 67), cases[i].flip, 1e-5);
        pair_free(&pair);
    }
}

/* L* is 0 and 100. L*a*b* of green is 87.736 -86.180 83.186, of blue 32.301
 * 79.196 -107.856; Hunt's adjustment multiplies a* and b* by L* / 100. */
static void flip_of_black_and_white_by_hand(void **state)
{
    (void)state;
    double a = 0.87736 * -86.180 - 0.32301 * 79.196;
    double b = 0.87736 * 83.186 - 0.32301 * -107.856;
    double limit = pow(87.736 - 32.301 + hypot(a, b), 0.7);
    double knee = 0.4 * limit;
    double wanted = 0.95 + 0.05 * (pow(100, 0.7) - knee) / (limit - knee);
    struct pair pair = pair_new(image_of(3, 3, 0, 0, 0),
                                image_of(3, 3, 1, 1, 1), SPACE_DISPLAY);
    assert_float_equal(flip_mean_of(&pair, 67), wanted, 1e-4);
    pair_free(&pair);
}

/* 20 x 14 pixels of waves, and the same one pixel further right. */
static struct pair waves(void)
{
    struct image *a = image_of(20, 14, 0, 0, 0), *b = image_of(20, 14, 0, 0, 0);
    for (int y = 0; y < 14; y++) {
        for (int x = 0; x < 20; x++) {
            for (int c = 0; c < 3; c++) {
                double v = 0.5 + 0.5 * sin(x * 0.7 + c) * cos(y * 0.5 - c);
                float level = (float)(rint(255 * v) / 255);
                image_pixel(a, x, y)[c] = level;
                if (x < 19)
                    image_pixel(b, x + 1, y)[c] = level;
                if (x == 0)
                    image_pixel(b, 0, y)[c] = level;
            }
        }
    }
    return pair_new(a, b, SPACE_DISPLAY);
}

static void shifted_waves_as_by_the_formulas(void **state)
{
    (void)state;
    struct pair pair = waves();
    struct plane map = flip_map(&pair, 67);
    assert_float_equal(plane_mean(&map, 0), 0.4663059, 1e-5);
    assert_float_equal((double)map.values[0], 0.347660, 1e-5);
    assert_float_equal((double)map.values[5 * 20 + 7], 0.313670, 1e-5);
    plane_free(&map);
    assert_float_equal(flip_mean_of(&pair, 30), 0.6219392, 1e-5);
    assert_float_equal(ssim_mean(&pair), 0.7600544, 1e-5);
    pair_free(&pair);
}

/* Without variance equation 13 is (2ab + C1) / (a^2 + b^2 + C1). */
static void ssim_of_even_pictures(void **state)
{
    (void)state;
    struct pair pair =
        pair_new(image_of(16, 16, 0.5, 0.5, 0.5),
                 image_of(16, 16, 0.25, 0.25, 0.25), SPACE_DISPLAY);
    assert_float_equal(ssim_mean(&pair), (0.2501 / 0.3126), 1e-4);
    pair_free(&pair);
    pair = pair_new(image_of(16, 16, 0, 0, 0), image_of(16, 16, 1, 1, 1),
                    SPACE_DISPLAY);
    assert_float_equal(ssim_mean(&pair), (0.0001 / 1.0001), 1e-6);
    pair_free(&pair);
    struct image *same = image_of(4, 4, 0.3, 0.6, 0.9);
    pair = pair_new(same, image_of(4, 4, 0.3, 0.6, 0.9), SPACE_DISPLAY);
    assert_float_equal(ssim_mean(&pair), 1, 1e-9);
    pair_free(&pair);
}

/* A: 0.2 and 0.4 by turns, B = 0.5 A + 0.1 = 0.2 and 0.3. */
static void sums_by_hand(void **state)
{
    (void)state;
    struct image *a = image_of(10, 10, 0.2, 0.2, 0.2);
    struct image *b = image_of(10, 10, 0.2, 0.2, 0.2);
    for (int i = 0; i < 400; i += 8)
        for (int c = 0; c < 3; c++) {
            a->pixels[i + c] = 0.4f;
            b->pixels[i + c] = 0.3f;
        }
    struct pair pair = pair_new(a, b, SPACE_RAW);
    struct figures f = figures_find(&pair, 0.05);
    assert_float_equal(f.mean, 0.05, 1e-6);
    assert_float_equal(f.mean_relative, 0.125, 1e-6);
    assert_float_equal(f.percentile, 0.1, 1e-6);
    assert_float_equal(f.percentile_relative, 0.25, 1e-6);
    assert_float_equal(f.largest, 0.1, 1e-6);
    assert_float_equal(f.rmse, sqrt(0.005), 1e-6);
    assert_float_equal(f.psnr, (-10 * log10(0.005)), 1e-4);
    assert_float_equal(f.over, 0.5, 0);
    assert_float_equal(f.slope, 0.5, 1e-5);
    assert_float_equal(f.bias, 0.1, 1e-5);
    assert_float_equal(f.ratio, (0.25 / 0.3), 1e-6);
    pair_free(&pair);
}

/* 100 values: the 99th percentile is the 99th, one may be larger. */
static void percentile_leaves_one_in_a_hundred(void **state)
{
    (void)state;
    struct image *a = image_of(100, 1, 0, 0, 0);
    struct image *b = image_of(100, 1, 0, 0, 0);
    for (int x = 0; x < 100; x++)
        for (int c = 0; c < 3; c++)
            image_pixel(b, x, 0)[c] = (float)((x * 37) % 100);
    struct pair pair = pair_new(a, b, SPACE_RAW);
    struct figures f = figures_find(&pair, 0.5);
    assert_float_equal(f.percentile, 98, 0);
    assert_float_equal(f.largest, 99, 0);
    assert_true(isnan(f.slope) && isnan(f.ratio));
    assert_float_equal(f.over, 0.99, 1e-12);
    pair_free(&pair);
}

static void broken_numbers_are_counted(void **state)
{
    (void)state;
    struct image *a = image_of(5, 1, 0.5, 0.5, 0.5);
    struct image *b = image_of(5, 1, 0.5, 0.5, 0.5);
    image_pixel(a, 0, 0)[1] = NAN;
    image_pixel(b, 0, 0)[1] = NAN;
    image_pixel(a, 1, 0)[2] = INFINITY;
    image_pixel(b, 1, 0)[2] = INFINITY;
    struct pair same = pair_new(a, b, SPACE_RAW);
    assert_true(same.identical);
    assert_int_equal(figures_find(&same, 0).broken, 0);
    image_pixel(b, 2, 0)[0] = NAN;
    struct pair pair = pair_new(a, b, SPACE_RAW);
    struct figures f = figures_find(&pair, 0.1);
    assert_false(pair.identical);
    assert_int_equal(f.broken, 1);
    assert_int_equal(f.pixels_over, 1);
    assert_true(isfinite(f.mean) && isfinite(f.rmse));
    pair_free(&pair);
}

/* An 8-bit sRGB file, one with gamma 2 in it, and a linear one, of the same
 * light: 0.5. */
static void spaces_meet(void **state)
{
    (void)state;
    static const double encoded = 0.735356983;
    for (int space = SPACE_DISPLAY; space <= SPACE_LINEAR; space++) {
        double wanted = space == SPACE_LINEAR ? 0.5 : encoded;
        for (int kind = 0; kind < 3; kind++) {
            double v = kind == 0 ? encoded : kind == 1 ? sqrt(0.5) : 0.5;
            struct image *a = image_of(1, 1, v, v, v);
            a->gamma = kind == 1 ? 2 : 0;
            a->linear = kind == 2;
            struct image *b = image_of(1, 1, 1.5, 1.5, 1.5);
            b->linear = true;
            struct pair pair = pair_new(a, b, (enum pair_space)space);
            assert_float_equal((double)a->pixels[0], wanted, 1e-6);
            /* Beside integers, light over 1 is cut, as they had to be. */
            assert_true((b->pixels[0] > 1) == (kind == 2));
            pair_free(&pair);
        }
    }
}

/* Half opaque: light 0.5 seen on black is 0.25. */
static void opacity_is_seen_on_black(void **state)
{
    (void)state;
    double v = 0.735356983 * 0.5;
    struct image *a = image_of(1, 1, v, v, v), *b = image_of(1, 1, 0, 0, 0);
    a->pixels[3] = 0.5f;
    struct pair pair = pair_new(a, b, SPACE_LINEAR);
    assert_float_equal((double)a->pixels[0], 0.25, 1e-6);
    pair_free(&pair);
}

/* Safe for the colour-blind because it only ever gets lighter. */
static void heat_gets_lighter(void **state)
{
    (void)state;
    double before = -1;
    for (int i = 0; i <= 100; i++) {
        float c[3];
        ramp_colour(RAMP_MAGMA, i / 100.0, c);
        double luma = 0.2126 * (double)c[0] + 0.7152 * (double)c[1] +
                      0.0722 * (double)c[2];
        assert_true(luma > before);
        before = luma;
    }
    float beyond[3], last[3];
    ramp_colour(RAMP_MAGMA, HUGE_VAL, beyond);
    ramp_colour(RAMP_MAGMA, 1, last);
    assert_memory_equal(beyond, last, sizeof last);
    ramp_colour(RAMP_MAGMA, (double)NAN, beyond);
    ramp_colour(RAMP_MAGMA, 0, last);
    assert_memory_equal(beyond, last, sizeof last);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flip_of_even_pictures),
        cmocka_unit_test(flip_of_black_and_white_by_hand),
        cmocka_unit_test(shifted_waves_as_by_the_formulas),
        cmocka_unit_test(ssim_of_even_pictures),
        cmocka_unit_test(sums_by_hand),
        cmocka_unit_test(percentile_leaves_one_in_a_hundred),
        cmocka_unit_test(broken_numbers_are_counted),
        cmocka_unit_test(spaces_meet),
        cmocka_unit_test(opacity_is_seen_on_black),
        cmocka_unit_test(heat_gets_lighter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
