/* Tone curves, conversion to file numbers (values measured on POV-Ray 3.7),
 * and what is written is what is read back. Runs in a directory of its own. */
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/random.h"
#include "base/save.h"
#include "image/file.h"
#include "image/output.h"
#include "image/tone.h"

static char directory[] = "/tmp/glim-image-XXXXXX";

static int setup(void **state)
{
    (void)state;
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    return chdir("/") == 0 && rmdir(directory) == 0 ? 0 : -1;
}

static void curves_are_those_of_the_standard(void **state)
{
    (void)state;
    assert_float_equal(tone_srgb_encode(0.5), 0.735357, 1e-6);
    assert_float_equal(tone_srgb_encode(0.002), 0.02584, 1e-6);
    assert_float_equal(tone_srgb_decode(-0.2), -0.0154799, 1e-6);
    for (int i = -10; i <= 30; i++) {
        double v = i / 20.0;
        assert_float_equal(tone_srgb_decode(tone_srgb_encode(v)), v, 1e-6);
    }
    assert_float_equal(tone_decode(0.5, 2.2), 0.217638, 1e-6);
    assert_float_equal(tone_decode(-0.5, 2.2), 0, 0);
    assert_float_equal(tone_encode(0.25, 2), 0.5, 1e-9);
    assert_float_equal(tone_encode(-3, 1), -3, 0);
}

static void assert_level(const struct tone_table *table, float v)
{
    double light = tone_decode((double)v, table->from);
    unsigned exact =
        tone_level((float)tone_encode(light, table->to), table->top);
    assert_int_equal(tone_table_level(table, v), exact);
}

static void assert_levels(double from, double to, unsigned top)
{
    struct tone_table table;
    tone_table_fill(&table, from, to, top);
    for (int i = 0; i <= 5000; i++)
        assert_level(&table, (float)(i / 5000.0));
    for (unsigned i = 1; i <= top; i++) {
        assert_level(&table, table.begin[i]);
        assert_level(&table, nextafterf(table.begin[i], 0));
    }
}

static void tables_of_levels_are_exact(void **state)
{
    static const double gammas[] = { 0, 1, 2.2, 0.5 };
    static const unsigned tops[] = { 1, 31, 255 };
    (void)state;
    for (size_t from = 0; from < 4; from++)
        for (size_t to = 0; to < 4; to++)
            for (size_t t = 0; t < 3; t++)
                assert_levels(gammas[from], gammas[to], tops[t]);
}

/* Numbers from below 0 to above 1, of all opacities. */
static void assert_same_levels(struct output_space space)
{
    struct output_space table = space;
    struct image *a = image_new(300, 200), *b = image_new(300, 200);
    table.bits = 8;
    for (int i = 0; i < 300 * 200 * 4; i++)
        a->pixels[i] = b->pixels[i] =
            i % 4 == 3 ? (float)(i % 97) / 90
                       : (float)(i * 1.1 / (300 * 200 * 4) - 0.05);
    a->pixels[0] = b->pixels[0] = NAN;
    output_convert(a, &space, 2);
    output_convert(b, &table, 2);
    for (int i = 0; i < 300 * 200 * 4; i++)
        assert_int_equal(tone_level(a->pixels[i], 255),
                         tone_level(b->pixels[i], 255));
    image_free(a);
    image_free(b);
}

/* A large picture's numbers are made levels by a table. */
static void large_pictures_have_the_same_levels(void **state)
{
    (void)state;
    for (int alpha = 0; alpha < 2; alpha++) {
        assert_same_levels(
            (struct output_space){ .working_gamma = 1, .alpha = alpha });
        assert_same_levels(
            (struct output_space){ .keep_numbers = true, .alpha = alpha });
        assert_same_levels((struct output_space){
            .working_gamma = 2.2, .file_gamma = 1.8, .alpha = alpha });
    }
}

/* What a part file holds of finished pixels: as good as all of them. */
static void levels_stand_for_pixels(void **state)
{
    (void)state;
    enum { COUNT = 200 };
    const struct output_space space = { .working_gamma = 1, .bits = 8 };
    struct output_space others[] = { space, space, space, space };
    struct tone_table table;
    unsigned char levels[COUNT * OUTPUT_LEVELS], again[COUNT * OUTPUT_LEVELS];
    float pixels[COUNT * 4], numbers[COUNT * 4];
    for (int i = 0; i < COUNT * 4; i++)
        pixels[i] = (float)(i - 40) / (COUNT * 3);
    output_levels_fill(&space, &table);
    output_levels_of(&table, pixels, COUNT, levels);
    output_levels_working(&table, levels, COUNT, numbers);
    output_levels_of(&table, numbers, COUNT, again);
    assert_memory_equal(levels, again, sizeof levels);
    output_levels_numbers(&table, levels, COUNT, numbers);
    for (int i = 0; i < COUNT * 4; i++) {
        double light = i % 4 < 3 ? (double)pixels[i] : 1;
        light = light > 0 ? light : 0;
        assert_int_equal(tone_level(numbers[i], 255),
                         tone_level((float)tone_srgb_encode(light), 255));
    }
    others[0].alpha = others[1].grey = others[2].linear_file = true;
    others[3].bits = 16;
    assert_true(output_has_levels(&space));
    for (int i = 0; i < 4; i++)
        assert_false(output_has_levels(&others[i]));
}

/* One pixel through output_convert. */
static struct image *convert(const float pixel[4], struct output_space space)
{
    struct image *image = image_new(1, 1);
    memcpy(image->pixels, pixel, 4 * sizeof(float));
    output_convert(image, &space, 2);
    return image;
}

static void expect(const float pixel[4], struct output_space space,
                   const double wanted[4])
{
    struct image *image = convert(pixel, space);
    for (int i = 0; i < 4; i++)
        assert_float_equal((double)image->pixels[i], wanted[i], 2e-5);
    image_free(image);
}

static const float plain[4] = { 0.5f, 0.18f, 0.002f, 1 };
static const float beyond[4] = { 1.5f, -0.2f, 0.9f, 1 };
static const float half[4] = { 0.375f, 0.1875f, 0.75f, 0.75f };

static void linear_scenes_are_encoded(void **state)
{
    (void)state;
    struct output_space png = { .working_gamma = 1 };
    expect(plain, png, (double[]){ 0.735357, 0.461356, 0.02584, 1 });
    expect(beyond, png, (double[]){ 1, 0, 0.954687, 1 });
    struct output_space alpha = { .working_gamma = 1, .alpha = true };
    expect(half, alpha, (double[]){ 0.735357, 0.537099, 1, 0.75 });
    struct output_space exr = { .working_gamma = 1, .linear_file = true };
    expect(beyond, exr, (double[]){ 1.5, -0.2, 0.9, 1 });
    exr.no_negative = true;
    expect(beyond, exr, (double[]){ 1.5, 0, 0.9, 1 });
    struct output_space file = { .working_gamma = 1, .file_gamma = 2.2 };
    expect(plain, file, (double[]){ 0.729740, 0.458672, 0.059323, 1 });
}

static void gamma_scenes_are_decoded_first(void **state)
{
    (void)state;
    struct output_space png = { .working_gamma = 2.2 };
    expect(plain, png, (double[]){ 0.503868, 0.164065, 0.000015, 1 });
    struct output_space exr = { .working_gamma = 2.2, .linear_file = true };
    expect(beyond, exr, (double[]){ 2.44006, 0, 0.793115, 1 });
    expect(half, exr, (double[]){ 0.115583, 0.025155, 0.531049, 0.75 });
}

static void without_assumed_gamma_numbers_stay(void **state)
{
    (void)state;
    struct output_space png = { .keep_numbers = true, .file_gamma = 2.2 };
    expect(plain, png, (double[]){ 0.5, 0.18, 0.002, 1 });
    struct output_space exr = { .keep_numbers = true, .linear_file = true };
    expect(plain, exr, (double[]){ 0.214041, 0.027212, 0.0001548, 1 });
    expect(beyond, exr, (double[]){ 2.537155, -0.015480, 0.787412, 1 });
}

static void grey_has_povrays_weights(void **state)
{
    (void)state;
    struct output_space grey = { .working_gamma = 1, .grey = true };
    expect(plain, grey, (double[]){ 0.541756, 0.541756, 0.541756, 1 });
    expect(beyond, grey, (double[]){ 0.687434, 0.687434, 0.687434, 1 });
}

static void wild_numbers_are_tamed(void **state)
{
    (void)state;
    const float wild[4] = { NAN, INFINITY, -INFINITY, NAN };
    struct output_space png = { .working_gamma = 1 };
    expect(wild, png, (double[]){ 0, 1, 0, 0 });
    struct output_space exr = { .working_gamma = 1,
                                .linear_file = true,
                                .half = true };
    expect(wild, exr, (double[]){ 0, 65504, -65504, 0 });
    const float much[4] = { 1e6f, -1e30f, 65504, 1 };
    expect(much, exr, (double[]){ 65504, -65504, 65504, 1 });
    exr.half = false;
    expect(much, exr, (double[]){ (double)1e6f, (double)-1e30f, 65504, 1 });
}

/* A ramp of all kinds of numbers. */
static struct image *ramp(void)
{
    struct image *image = image_new(40, 5);
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 40; x++) {
            float *pixel = image_pixel(image, x, y);
            pixel[0] = (float)x / 39;
            pixel[1] = (float)y / 4;
            pixel[2] = (float)(x * y) / 156;
            pixel[3] = (float)(x + y) / 43;
        }
    return image;
}

/* The largest difference of a channel after a round trip. Straight colours
 * come back premultiplied. */
static double round_trip(const char *path, struct image_format format,
                         bool premultiplied)
{
    char error[256] = "";
    struct image *out = ramp();
    for (int i = 0; format.grey && i < 40 * 5; i++)
        out->pixels[i * 4 + 1] = out->pixels[i * 4 + 2] = out->pixels[i * 4];
    if (!image_write(out, path, &format, error, sizeof error))
        fail_msg("%s: %s", path, error);
    struct image *in = image_read(path, error, sizeof error);
    if (!in)
        fail_msg("%s: %s", path, error);
    assert_int_equal(in->width, 40);
    assert_int_equal(in->height, 5);
    assert_int_equal(in->has_alpha, format.alpha);
    double worst = 0;
    for (int i = 0; i < 40 * 5 * 4; i++) {
        float wanted = out->pixels[i];
        float opacity = format.alpha ? out->pixels[i / 4 * 4 + 3] : 1;
        if (i % 4 == 3)
            wanted = opacity;
        else if (premultiplied)
            wanted *= opacity;
        worst = fmax(worst, fabs((double)wanted - (double)in->pixels[i]));
    }
    image_free(in);
    image_free(out);
    assert_int_equal(unlink(path), 0);
    return worst;
}

static void formats_come_back(void **state)
{
    (void)state;
    struct image_format png = { .type = "png", .bits = 8 };
    assert_true(round_trip("a.png", png, true) <= 0.5 / 255 + 1e-6);
    png.bits = 16;
    assert_true(round_trip("a.png", png, true) <= 0.5 / 65535 + 1e-6);
    png.bits = 12;
    assert_true(round_trip("a.png", png, true) <= 0.55 / 4095);
    png.alpha = true;
    assert_true(round_trip("a.png", png, true) <= 1.1 / 4095);
    png.grey = true;
    png.alpha = false;
    assert_true(round_trip("a.png", png, true) <= 0.55 / 4095);
    png.alpha = true;
    assert_true(round_trip("a.png", png, true) <= 1.1 / 4095);
    struct image_format exr = { .type = "openexr", .alpha = true };
    assert_true(round_trip("a.exr", exr, false) <= 0.0005);
    exr.bits = 32;
    assert_true(round_trip("a.exr", exr, false) <= 0);
    exr.grey = true;
    assert_true(round_trip("a.exr", exr, false) <= 0);
    exr.alpha = false;
    assert_true(round_trip("a.exr", exr, false) <= 0);
    struct image_format hdr = { .type = "hdr" };
    assert_true(round_trip("a.hdr", hdr, true) <= 1.0 / 128);
    struct image_format tga = { .type = "targa", .bits = 8, .alpha = true };
    assert_true(round_trip("a.tga", tga, true) <= 1.01 / 255);
    tga.packed = true;
    assert_true(round_trip("a.tga", tga, true) <= 1.01 / 255);
    struct image_format bmp = { .type = "bmp", .bits = 8 };
    assert_true(round_trip("a.bmp", bmp, true) <= 0.5 / 255 + 1e-6);
    bmp.alpha = true;
    assert_true(round_trip("a.bmp", bmp, true) <= 1.01 / 255);
    bmp.alpha = false;
    bmp.grey = true;
    assert_true(round_trip("a.bmp", bmp, true) <= 0.5 / 255 + 1e-6);
    struct image_format ppm = { .type = "pnm", .bits = 8 };
    assert_true(round_trip("a.ppm", ppm, true) <= 0.5 / 255 + 1e-6);
    ppm.bits = 16; /* of which OIIO 2.4 reads but 8 */
    assert_true(round_trip("a.ppm", ppm, true) <= 1.01 / 255);
    ppm.grey = true;
    assert_true(round_trip("a.ppm", ppm, true) <= 1.01 / 255);
    struct image_format jpeg = { .type = "jpeg", .bits = 8, .quality = 95 };
    assert_true(round_trip("a.jpg", jpeg, true) <= 0.1);
    jpeg.grey = true;
    assert_true(round_trip("a.jpg", jpeg, true) <= 0.1);
}

/* A picture of one row of blocks and a row more, of numbers that zlib can't
 * pack and of those that are hard to round. */
static struct image *hard_numbers(void)
{
    static const float numbers[] = { 0,       1,        -1,      65504,
                                     65519,   6.1e-5f,  6e-5f,   1e-7f,
                                     8.9e-8f, 2.98e-8f, 2.9e-8f, -3e-6f,
                                     2049,    2051,     1.0005f, 0.33333f };
    struct image *image = image_new(60, 17);
    for (int i = 0; i < 60 * 17 * 4; i++)
        image->pixels[i] = i < 60 ? numbers[i % 16]
                                  : (float)random_unit((uint64_t)i) *
                                        powf(10, (float)(i % 9 - 4));
    return image;
}

static void exr_numbers_are_the_nearest(void **state)
{
    (void)state;
    char error[256] = "";
    struct image *out = hard_numbers();
    struct image_format exr = { .type = "openexr", .alpha = true };
    for (exr.bits = 16; exr.bits <= 32; exr.bits += 16) {
        if (!image_write(out, "a.exr", &exr, error, sizeof error))
            fail_msg("%s", error);
        struct image *in = image_read("a.exr", error, sizeof error);
        if (!in)
            fail_msg("%s", error);
        for (int i = 0; i < 60 * 17 * 4; i++) {
            double wanted = (double)out->pixels[i];
            int power;
            frexp(wanted, &power);
            double step = ldexp(1, power < -13 ? -24 : power - 11);
            if (exr.bits == 16)
                wanted = rint(wanted / step) * step;
            assert_float_equal((double)in->pixels[i], wanted, 0);
        }
        image_free(in);
    }
    image_free(out);
    assert_int_equal(unlink("a.exr"), 0);
}

/* 5 x 5 pixels in three interlaced passes of two bits: numbers of a palette of
 * which the last is half transparent. */
static void write_palette(const char *path)
{
    png_color palette[] = { { 255, 0, 0 }, { 0, 51, 0 }, { 0, 0, 255 } };
    png_byte alpha[] = { 255, 255, 127 };
    FILE *file = fopen(path, "wb");
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    assert_non_null(file);
    png_init_io(png, file);
    png_set_IHDR(png, info, 5, 5, 2, PNG_COLOR_TYPE_PALETTE,
                 PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_PLTE(png, info, palette, 3);
    png_set_tRNS(png, info, alpha, 3, NULL);
    png_set_gAMA(png, info, 0.45455);
    png_write_info(png, info);
    png_set_packing(png);
    for (int pass = png_set_interlace_handling(png); pass > 0; pass--)
        for (int y = 0; y < 5; y++) {
            png_byte row[5];
            for (int x = 0; x < 5; x++)
                row[x] = (png_byte)((x + 2 * y) % 3);
            png_write_row(png, row);
        }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    fclose(file);
}

static void palettes_are_spread(void **state)
{
    static const float wanted[3][4] = {
        { 1, 0, 0, 1 },
        { 0, 0.2f, 0, 1 },
        { 0, 0, 127 / 255.0f, 127 / 255.0f },
    };
    (void)state;
    char error[256] = "";
    write_palette("a.png");
    struct image *image = image_read("a.png", error, sizeof error);
    assert_non_null(image);
    assert_true(image->has_alpha && !image->linear && image->gamma == 2.2);
    for (int i = 0; i < 25; i++)
        for (int c = 0; c < 4; c++)
            assert_float_equal(image_pixel(image, i % 5, i / 5)[c],
                               wanted[(i % 5 + 2 * (i / 5)) % 3][c], 1e-6);
    image_free(image);
    unlink("a.png");
}

static void failures_leave_nothing(void **state)
{
    (void)state;
    char error[256] = "";
    struct image *image = ramp();
    struct image_format png = { .type = "png", .bits = 8 };
    assert_false(image_write(image, "no/a.png", &png, error, sizeof error));
    assert_string_equal(error, "No such file or directory");
    assert_false(save_possible("no/a.png", error, sizeof error));
    assert_string_equal(error, "there is no directory 'no'");
    assert_false(save_possible("..", error, sizeof error));
    assert_true(save_possible("a.png", error, sizeof error));
    assert_true(save_possible("-", error, sizeof error));
    assert_false(image_write(image, "/dev/full", &png, error, sizeof error));
    assert_string_equal(error, "No space left on device");
    assert_null(image_read("a.png", error, sizeof error));
    assert_string_equal(error, "No such file or directory");
    assert_null(image_read(".", error, sizeof error));
    image_free(image);
}

static void files_cut_short_are_noticed(void **state)
{
    (void)state;
    char error[256] = "";
    struct image *image = ramp();
    struct image_format png = { .type = "png", .bits = 8 };
    assert_true(image_write(image, "a.png", &png, error, sizeof error));
    int width = 0, height = 0;
    assert_true(image_probe("a.png", &width, &height, error, sizeof error));
    assert_int_equal(width, 40);
    assert_int_equal(height, 5);
    struct stat status;
    assert_int_equal(stat("a.png", &status), 0);
    assert_int_equal(truncate("a.png", status.st_size / 2), 0);
    assert_false(image_probe("a.png", &width, &height, error, sizeof error));
    assert_string_equal(error, "it is cut short");
    assert_int_equal(truncate("a.png", 0), 0);
    assert_false(image_probe("a.png", &width, &height, error, sizeof error));
    assert_string_equal(error, "it is empty");
    unlink("a.png");
    image_free(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_of_levels_are_exact),
        cmocka_unit_test(large_pictures_have_the_same_levels),
        cmocka_unit_test(levels_stand_for_pixels),
        cmocka_unit_test(curves_are_those_of_the_standard),
        cmocka_unit_test(linear_scenes_are_encoded),
        cmocka_unit_test(gamma_scenes_are_decoded_first),
        cmocka_unit_test(without_assumed_gamma_numbers_stay),
        cmocka_unit_test(grey_has_povrays_weights),
        cmocka_unit_test(wild_numbers_are_tamed),
        cmocka_unit_test(formats_come_back),
        cmocka_unit_test(exr_numbers_are_the_nearest),
        cmocka_unit_test(palettes_are_spread),
        cmocka_unit_test(failures_leave_nothing),
        cmocka_unit_test(files_cut_short_are_noticed),
    };
    return cmocka_run_group_tests_name("image", tests, setup, teardown);
}
