/* Tests of bright.h: where most of the light comes from, and rays aimed there.
 */
#include "harness.h"

#include "base/draw.h"
#include "base/random.h"
#include "base/warp.h"
#include "lightmesh/bright.h"

enum { HITS = 1000, RAYS = 20000 };

/* Hits on the floor of a room, of which a patch of one metre is lit. */
static void floor_hits(struct bright_hit hits[HITS], double light)
{
    for (uint64_t i = 0; i < HITS; i++) {
        double x = 10 * random_unit(2 * i), z = 10 * random_unit(2 * i + 1);
        bool lit = x > 4 && x < 5 && z > 4 && z < 5;
        hits[i] = (struct bright_hit){ vec3_make(x, 0, z), lit ? light : 0.01 };
    }
}

static void finds_the_patch(void **state)
{
    struct bright_hit hits[HITS];
    (void)state;
    floor_hits(hits, 10);
    struct bright bright = bright_of(hits, HITS);
    assert_true(bright.count > 0);
    for (int i = 0; i < bright.count; i++) {
        assert_true(fabs(bright.at[i].centre.x - 4.5) <= 1);
        assert_true(fabs(bright.at[i].centre.z - 4.5) <= 1);
    }
}

static void finds_none_where_all_is_alike(void **state)
{
    struct bright_hit hits[HITS];
    (void)state;
    floor_hits(hits, 0.02);
    assert_int_equal(bright_of(hits, HITS).count, 0);
    assert_int_equal(bright_of(hits, 0).count, 0);
    assert_int_equal(bright_of(hits, 1).count, 0);
}

/* Directions come as often as their density says: the mean of 1/density over
 * them is the solid angle in which there are any, as directions that are sent
 * everywhere find it. */
static void aims_as_often_as_it_says(void **state)
{
    struct bright_hit hits[HITS];
    struct aim aim;
    double aimed = 0, even = 0;
    (void)state;
    floor_hits(hits, 10);
    struct bright bright = bright_of(hits, HITS);
    aim_take(&aim, &bright, vec3_make(2, 2, 7));
    for (uint32_t i = 0; i < RAYS; i++) {
        const struct draws draws = { 1, i };
        double u[2];
        draw_pair(&draws, 0, u);
        aimed += 1 / aim_density(&aim, aim_way(&aim, u)) / RAYS;
        even += (aim_density(&aim, warp_sphere(u)) > 0) * 4 * WARP_PI / RAYS;
    }
    assert_true(aimed > 0.01 && fabs(aimed - even) < 0.02 * even);
}

/* A place within a bright ball sends its rays everywhere. */
static void looks_around_within(void **state)
{
    struct bright bright = { .count = 1, .radius = 1 };
    struct aim aim;
    (void)state;
    bright.at[0].light = 1;
    bright.at[0].centre = vec3_make(0, 0, 0);
    aim_take(&aim, &bright, vec3_make(0.1, 0.2, 0));
    assert_true(fabs(aim_density(&aim, vec3_make(0, -1, 0)) * 4 * WARP_PI - 1) <
                1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_patch),
        cmocka_unit_test(finds_none_where_all_is_alike),
        cmocka_unit_test(aims_as_often_as_it_says),
        cmocka_unit_test(looks_around_within),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
