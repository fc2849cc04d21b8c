/* The order of tiles: the longest first, each once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "render/tile_order.h"

enum { WIDE = 5, COUNT = 20 };

static void the_longest_come_first(void **state)
{
    /* The first pass has a column and a row more. */
    struct tile_order order = { .tiles = NULL };
    int seen[COUNT] = { 0 };
    (void)state;
    tile_order_start(&order, WIDE + 1, (WIDE + 1) * 5);
    for (size_t i = 0; i < (WIDE + 1) * 5; i++)
        tile_order_note(&order, i, (double)(i * 7 % 11));
    assert_int_equal(tile_order_at(&order, 3), 3);
    tile_order_sort(&order, WIDE, COUNT);
    for (size_t i = 0; i < COUNT; i++) {
        size_t tile = tile_order_at(&order, i);
        assert_true(tile < COUNT);
        seen[tile]++;
        if (i == 0)
            continue;
        size_t before = tile_order_at(&order, i - 1);
        double here = order.seconds[tile / WIDE * (WIDE + 1) + tile % WIDE];
        double there =
            order.seconds[before / WIDE * (WIDE + 1) + before % WIDE];
        assert_true(here < there || (here == there && before < tile));
    }
    for (size_t i = 0; i < COUNT; i++)
        assert_int_equal(seen[i], 1);
    tile_order_end(&order);
    assert_int_equal(tile_order_at(&order, 3), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_longest_come_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
