/* Part files: what is whole is as it was put in, whatever happens to the file.
 * Runs in a directory of its own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "image/output.h"
#include "image/part_file.h"
#include "render/share.h"

enum { WIDTH = 20, HEIGHT = 9, TILE = 8 };

static char directory[] = "/tmp/glim-part-XXXXXX";
static const char name[] = "a.glim-part", text[] = "glim 0.1\nwidth 20\n";

static int setup(void **state)
{
    (void)state;
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    unlink(name);
    return chdir("/") == 0 && rmdir(directory) == 0 ? 0 : -1;
}

/* The tiles on the left are opaque. */
static float value_at(int x, int y, int channel)
{
    if (channel == 3 && x < TILE)
        return 1;
    return (float)(y * 100 + x) + (float)channel / 8;
}

static struct area tile_area(int i)
{
    struct area area = { i % 3 * TILE, i / 3 * TILE, 0, 0 };
    area.right = area.left + TILE < WIDTH ? area.left + TILE : WIDTH;
    area.bottom = area.top + TILE < HEIGHT ? area.top + TILE : HEIGHT;
    return area;
}

static void put_tile(struct part_file *file, int i)
{
    float values[TILE * TILE * 4], *to = values;
    struct area area = tile_area(i);
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            for (int k = 0; k < 4; k++)
                *to++ = value_at(x, y, k);
    part_file_put(file, PART_PIXELS, area, values);
}

static void make_file(void)
{
    char why[100];
    struct part_file *file =
        part_file_create(name, text, WIDTH, HEIGHT, why, sizeof why);
    assert_non_null(file);
    for (int i = 0; i < 6; i++)
        put_tile(file, i);
    assert_null(part_file_problem(file));
    part_file_close(file);
}

/* Every tile that is given must be right; counts its pixels. */
static void check_tile(void *context, struct area area, const void *values)
{
    size_t *pixels = context;
    const float *from = values;
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            for (int k = 0; k < 4; k++)
                assert_true(*from++ == value_at(x, y, k));
    *pixels += area_pixels(area);
}

/* Pixels that the file has; -1: it is refused. */
static int known_pixels(void)
{
    char why[100];
    const struct area all = { 0, 0, WIDTH, HEIGHT };
    struct part_file *file = part_file_open(name, why, sizeof why);
    size_t pixels = 0;
    if (!file)
        return -1;
    assert_string_equal(part_file_text(file), text);
    assert_int_equal(part_file_width(file), WIDTH);
    assert_int_equal(part_file_height(file), HEIGHT);
    part_file_each(file, PART_PIXELS, all, check_tile, &pixels);
    part_file_close(file);
    return (int)pixels;
}

static size_t read_file(char *bytes, size_t room)
{
    FILE *file = fopen(name, "rb");
    size_t count = fread(bytes, 1, room, file);
    fclose(file);
    return count;
}

static void write_file(const char *bytes, size_t count)
{
    FILE *file = fopen(name, "wb");
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

static char bytes[10000];

static void every_byte_may_be_wrong(void **state)
{
    (void)state;
    make_file();
    size_t count = read_file(bytes, sizeof bytes);
    assert_int_equal(known_pixels(), WIDTH * HEIGHT);
    for (size_t i = 0; i < count; i++)
        for (int bit = 0; bit < 8; bit += 7) {
            bytes[i] ^= (char)(1 << bit);
            write_file(bytes, count);
            int pixels = known_pixels();
            /* The head, or one of the tiles. */
            assert_true(pixels == -1 || (pixels >= WIDTH * HEIGHT - 64 &&
                                         pixels < WIDTH * HEIGHT));
            bytes[i] ^= (char)(1 << bit);
        }
}

static void every_length_is_taken(void **state)
{
    (void)state;
    make_file();
    size_t count = read_file(bytes, sizeof bytes);
    int before = -1;
    for (size_t length = 0; length <= count; length++) {
        write_file(bytes, length);
        int pixels = known_pixels();
        assert_true(pixels >= before);
        before = pixels;
    }
    assert_int_equal(before, WIDTH * HEIGHT);
}

/* What is added to a file that was cut off, or has a hole, is found again. */
static void damaged_files_go_on(void **state)
{
    (void)state;
    char why[100];
    make_file();
    size_t count = read_file(bytes, sizeof bytes);
    memset(bytes + 300, 0, 1000);
    write_file(bytes, count - 7);
    int before = known_pixels();
    assert_true(before > 0 && before < WIDTH * HEIGHT);
    struct part_file *file = part_file_open(name, why, sizeof why);
    assert_true(part_file_was_damaged(file));
    for (int i = 0; i < 6; i++)
        put_tile(file, i);
    part_file_close(file);
    assert_int_equal(known_pixels(), before + WIDTH * HEIGHT);
}

static void take_levels(void *context, struct area area, const void *values)
{
    const unsigned char *from = values, *wanted = context;
    assert_int_equal(area.top, 2);
    assert_memory_equal(from, wanted, area_pixels(area) * OUTPUT_LEVELS);
}

/* Levels are bytes, which are not floats where they look like these. */
static void levels_are_given_as_they_were(void **state)
{
    (void)state;
    char why[100];
    const struct area all = { 0, 0, WIDTH, HEIGHT }, area = { 1, 2, 5, 6 };
    unsigned char levels[16 * OUTPUT_LEVELS];
    float ones[4] = { 1, 1, 1, 1 };
    for (size_t i = 0; i < sizeof levels; i++)
        levels[i] = ((unsigned char *)ones)[i % sizeof ones];
    struct part_file *file =
        part_file_create(name, text, WIDTH, HEIGHT, why, sizeof why);
    part_file_put(file, PART_LEVELS, area, levels);
    part_file_close(file);
    file = part_file_open(name, why, sizeof why);
    assert_false(part_file_was_damaged(file));
    part_file_each(file, PART_LEVELS, all, take_levels, levels);
    part_file_close(file);
    assert_int_equal(known_pixels(), 0);
}

enum { OFTEN = 200 };

/* Takes the newest tally that each round wrote into all of its bytes. */
static void take_tally(void *context, struct area area, const void *values)
{
    const unsigned char *tally = values;
    int *newest = context;
    assert_int_equal(area.top, 1);
    for (size_t i = 1; i < area_pixels(area) * PART_TALLY; i++)
        assert_int_equal(tally[i], tally[0]);
    *newest = tally[0] > *newest ? tally[0] : *newest;
}

/* Two by turns: the file doesn't grow, and has the last one. */
static void tallies_take_the_place_of_others(void **state)
{
    char why[100];
    unsigned char tallies[WIDTH * PART_TALLY];
    const struct area row = { 0, 1, WIDTH, 2 };
    long long place[2] = { 0 };
    struct stat status;
    int newest = 0;
    (void)state;
    struct part_file *file =
        part_file_create(name, text, WIDTH, HEIGHT, why, sizeof why);
    for (int i = 1; i <= OFTEN; i++) {
        long long *at = &place[i % 2];
        memset(tallies, i, sizeof tallies);
        *at = *at ? part_file_replace(file, row, tallies, *at)
                  : part_file_put(file, PART_TALLIES, row, tallies);
        part_file_flush(file);
    }
    part_file_close(file);
    assert_int_equal(stat(name, &status), 0);
    assert_true(status.st_size < 3 * (off_t)sizeof tallies);
    file = part_file_open(name, why, sizeof why);
    assert_non_null(file);
    assert_false(part_file_was_damaged(file));
    part_file_each(file, PART_TALLIES, row, take_tally, &newest);
    assert_int_equal(newest, OFTEN);
    part_file_close(file);
}

static void one_process_at_a_time(void **state)
{
    (void)state;
    char why[100] = "?";
    struct part_file *file =
        part_file_create(name, text, WIDTH, HEIGHT, why, sizeof why);
    assert_null(part_file_open(name, why, sizeof why));
    assert_string_equal(why, "");
    assert_null(part_file_create(name, text, 1, 1, why, sizeof why));
    part_file_close(file);
    unlink(name);
    assert_null(part_file_open(name, why, sizeof why));
    assert_string_equal(why, "No such file or directory");
}

static void full_disks_are_told(void **state)
{
    (void)state;
    char why[100];
    struct rlimit limit, tight;
    struct part_file *file =
        part_file_create(name, text, WIDTH, HEIGHT, why, sizeof why);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    tight = limit;
    tight.rlim_cur = 1500;
    setrlimit(RLIMIT_FSIZE, &tight);
    for (int i = 0; i < 6; i++)
        put_tile(file, i);
    part_file_flush(file);
    setrlimit(RLIMIT_FSIZE, &limit);
    assert_string_equal(part_file_problem(file), "File too large");
    part_file_close(file);
    assert_int_equal(known_pixels(), 64);
}

/* Each pixel is one part's, and parts have about as much to do. */
static void shares_are_even(void **state)
{
    (void)state;
    static size_t pixels[40];
    for (int count = 1; count <= 40; count += 13) {
        memset(pixels, 0, sizeof pixels);
        for (int y = 0; y < 900; y += 4)
            for (int x = 0; x < 1600; x += 4) {
                int owners = 0;
                for (int i = 0; i < count; i++) {
                    struct share share = { i + 1, count };
                    bool has = share_has(&share, 1600, 900, x, y);
                    owners += has;
                    pixels[i] += has;
                }
                assert_int_equal(owners, 1);
            }
        size_t mean = 225 * 400 / (size_t)count;
        for (int i = 0; i < count; i++)
            assert_in_range(pixels[i], mean * 8 / 10, mean * 12 / 10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_byte_may_be_wrong),
        cmocka_unit_test(every_length_is_taken),
        cmocka_unit_test(damaged_files_go_on),
        cmocka_unit_test(levels_are_given_as_they_were),
        cmocka_unit_test(tallies_take_the_place_of_others),
        cmocka_unit_test(one_process_at_a_time),
        cmocka_unit_test(full_disks_are_told),
        cmocka_unit_test(shares_are_even),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
