/* Tests of lit_cells.h: the places that lamps light, and how much they bring.
 */
#include "harness.h"

#include "base/random.h"
#include "lightmesh/lit_cells.h"

enum { HITS = 2000 };

/* Rays down from a ceiling onto a floor of ten metres, of which a part is lit.
 */
static void floor_hits(struct bright_hit hits[HITS], double from, double to)
{
    for (uint64_t i = 0; i < HITS; i++) {
        double x = 10 * random_unit(2 * i), z = 10 * random_unit(2 * i + 1);
        hits[i] = (struct bright_hit){ .origin = vec3_make(x, 3, z),
                                       .direction = vec3_make(0, -1, 0),
                                       .normal = vec3_make(0, 1, 0),
                                       .distance = 3,
                                       .light = 1,
                                       .lamps = x >= from && x < to };
    }
}

/* All of it is found, and nothing else. */
static void finds_what_is_lit(void **state)
{
    struct bright_hit hits[HITS];
    double brought = 0;
    (void)state;
    floor_hits(hits, 3, 5);
    struct bright lit = lit_cells_of(hits, HITS);
    assert_true(lit.count > 0);
    for (int i = 0; i < lit.count; i++) {
        const struct bright_disc *disc = &lit.at[i];
        assert_true(disc->centre.x > 2 && disc->centre.x < 6);
        assert_true(fabs(disc->centre.y) < 1e-12 && disc->normal.y > 0.999);
        assert_true(disc->worth > 0 && disc->worth <= 1);
        brought += disc->brought;
    }
    assert_true(brought > 0.9 && brought < 1 + 1e-9);
}

/* Cells grow until few of them hold most of it. */
static void covers_a_large_floor(void **state)
{
    struct bright_hit hits[HITS];
    double brought = 0;
    (void)state;
    floor_hits(hits, 0, 10);
    struct bright lit = lit_cells_of(hits, HITS);
    for (int i = 0; i < lit.count; i++)
        brought += lit.at[i].brought;
    assert_true(brought > 0.9);
}

static void finds_none_in_the_dark(void **state)
{
    struct bright_hit hits[HITS];
    (void)state;
    floor_hits(hits, 0, 0);
    assert_int_equal(lit_cells_of(hits, HITS).count, 0);
    assert_int_equal(lit_cells_of(hits, 0).count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_what_is_lit),
        cmocka_unit_test(covers_a_large_floor),
        cmocka_unit_test(finds_none_in_the_dark),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
