/* Tiles are kept once a second, each once, and what is left at the end as that
 * is asked to. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/clock.h"
#include "render/keeper.h"

enum { TILES = 8 };

struct record {
    int puts[TILES];
    int settled;
};

static void note_put(void *context, size_t tile, unsigned thread)
{
    struct record *record = context;
    (void)thread;
    record->puts[tile]++;
}

static void note_settle(void *context)
{
    struct record *record = context;
    record->settled++;
}

/* There is no file, only the pointer to it. */
static struct part_file *make_none(void *context)
{
    return context;
}

static struct part_file *make_fails(void *context)
{
    (void)context;
    return NULL;
}

static void start(struct keeper *keeper, struct keeper_tiles *tiles,
                  struct record *record, double begin)
{
    memset(record, 0, sizeof *record);
    *keeper = (struct keeper){ .create = make_none,
                               .settle = note_settle,
                               .context = record };
    *tiles = (struct keeper_tiles){ .put = note_put, .context = record };
    keeper_start(keeper, begin);
    keeper_tiles_start(tiles, keeper, TILES);
}

static void check_puts(const struct record *record, int first, int others)
{
    for (int i = 0; i < TILES; i++)
        assert_int_equal(record->puts[i], i < 3 ? first : others);
}

static void tiles_wait_for_their_second(void **state)
{
    (void)state;
    struct keeper keeper;
    struct keeper_tiles tiles;
    struct record record;
    start(&keeper, &tiles, &record, clock_seconds() + 1000);
    keeper_tiles_done(&tiles, 0, 0);
    keeper_tiles_done(&tiles, 1, 0);
    check_puts(&record, 0, 0);
    assert_null(keeper.file);
    atomic_store(&keeper.next, 0);
    keeper_tiles_done(&tiles, 2, 0);
    check_puts(&record, 1, 0);
    assert_int_equal(record.settled, 1);
    for (size_t i = 3; i < TILES; i++)
        keeper_tiles_done(&tiles, i, 0);
    check_puts(&record, 1, 0);
    keeper_tiles_end(&tiles, 0);
    check_puts(&record, 1, 1);
    assert_int_equal(record.settled, 2);
}

static void the_last_second_can_be_left_out(void **state)
{
    (void)state;
    struct keeper keeper;
    struct keeper_tiles tiles;
    struct record record;
    start(&keeper, &tiles, &record, 0);
    keeper_tiles_done(&tiles, 0, 0);
    for (size_t i = 1; i < TILES; i++)
        keeper_tiles_done(&tiles, i, 0);
    keeper_tiles_end(&tiles, TILES);
    assert_int_equal(record.puts[0], 1);
    for (size_t i = 1; i < TILES; i++)
        assert_int_equal(record.puts[i], 0);
}

static void what_was_dropped_is_not_kept(void **state)
{
    (void)state;
    struct keeper keeper;
    struct keeper_tiles tiles;
    struct record record;
    start(&keeper, &tiles, &record, clock_seconds() + 1000);
    for (size_t i = 0; i < TILES; i++)
        keeper_tiles_done(&tiles, i, 0);
    for (size_t i = 0; i < 3; i++)
        keeper_tiles_drop(&tiles, i);
    atomic_store(&keeper.next, 0);
    keeper_tiles_done(&tiles, TILES - 1, 0);
    check_puts(&record, 0, 1);
    keeper_tiles_end(&tiles, 0);
    check_puts(&record, 0, 1);
}

static void the_end_can_begin_later(void **state)
{
    (void)state;
    struct keeper keeper;
    struct keeper_tiles tiles;
    struct record record;
    start(&keeper, &tiles, &record, clock_seconds() + 1000);
    for (size_t i = 0; i < TILES; i++)
        keeper_tiles_done(&tiles, i, 0);
    atomic_store(&keeper.next, 0);
    keeper_tiles_end(&tiles, 3);
    check_puts(&record, 0, 1);
}

static void what_cannot_be_begun_is_not_kept(void **state)
{
    (void)state;
    struct keeper keeper;
    struct keeper_tiles tiles;
    struct record record;
    start(&keeper, &tiles, &record, 0);
    keeper.create = make_fails;
    for (size_t i = 0; i < TILES; i++)
        keeper_tiles_done(&tiles, i, 0);
    keeper_tiles_end(&tiles, 0);
    check_puts(&record, 0, 0);
    assert_int_equal(record.settled, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiles_wait_for_their_second),
        cmocka_unit_test(the_last_second_can_be_left_out),
        cmocka_unit_test(what_was_dropped_is_not_kept),
        cmocka_unit_test(the_end_can_begin_later),
        cmocka_unit_test(what_cannot_be_begun_is_not_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
