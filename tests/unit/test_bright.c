/* Tests of bright.h: where most of the light comes from, and rays aimed there.
 */
#include "harness.h"

#include "base/draw.h"
#include "base/random.h"
#include "base/warp.h"
#include "lightmesh/bright.h"

enum { HITS = 1000, RAYS = 20000 };

/* What a ray down from the ceiling meets at a place of the floor. */
static struct bright_hit floor_hit(double x, double z, double light)
{
    return (struct bright_hit){ vec3_make(x, 3, z), vec3_make(0, -1, 0),
                                vec3_make(0, 1, 0), 3, light };
}

/* Hits on the floor of a room, of which a patch of one metre is lit. */
static void floor_hits(struct bright_hit hits[HITS], double light)
{
    for (uint64_t i = 0; i < HITS; i++) {
        double x = 10 * random_unit(2 * i), z = 10 * random_unit(2 * i + 1);
        bool lit = x > 4 && x < 5 && z > 4 && z < 5;
        hits[i] = floor_hit(x, z, lit ? light : 0.01);
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
        assert_true(fabs(bright.at[i].centre.y) < 1e-12);
        assert_true(fabs(bright.at[i].centre.z - 4.5) <= 1);
        assert_true(bright.at[i].normal.y > 0.999);
    }
}

/* Of a cube of 4 units, seen from its middle, every wall is met; through a
 * window in the one at x = 4 a bright plain far away, or the sky. */
static void aims_at_the_window(void **state)
{
    struct bright_hit hits[HITS];
    (void)state;
    for (int sky = 0; sky < 2; sky++) {
        for (uint32_t i = 0; i < HITS; i++) {
            const struct draws draws = { 1, i };
            double u[2];
            draw_pair(&draws, 0, u);
            vec3 way = warp_sphere(u),
                 size = vec3_make(fabs(way.x), fabs(way.y), fabs(way.z));
            double most = fmax(size.x, fmax(size.y, size.z));
            bool through =
                way.x == most && size.y < 0.25 * most && size.z < 0.25 * most;
            vec3 normal =
                vec3_make(-(size.x == most) * way.x, -(size.y == most) * way.y,
                          -(size.z == most) * way.z);
            hits[i] =
                (struct bright_hit){ vec3_make(2, 2, 2), way,
                                     vec3_normalise(normal), 2 / most, 0.01 };
            if (through) {
                hits[i].distance = sky ? HUGE_VAL : 1000 + i;
                hits[i].normal = vec3_make(0, 1, 0);
                hits[i].light = 10;
            }
        }
        struct bright bright = bright_of(hits, HITS);
        assert_true(bright.count > 0);
        for (int i = 0; i < bright.count; i++) {
            vec3 centre = bright.at[i].centre;
            assert_true(fabs(centre.x - 4) < 1e-6);
            assert_true(fabs(centre.y - 2) < 1 && fabs(centre.z - 2) < 1);
            assert_true(bright.at[i].normal.x < -0.999);
        }
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
 * those of one disc is the solid angle in which there are any, as directions
 * that are sent everywhere find it. */
static void aims_as_often_as_it_says(void **state)
{
    struct bright_hit hits[HITS];
    struct aim aim;
    double aimed = 0, even = 0;
    (void)state;
    floor_hits(hits, 10);
    struct bright bright = bright_of(hits, HITS);
    bright.count = 1;
    aim_take(&aim, &bright, vec3_make(2, 2, 7), 1);
    assert_true(fabs(aim.rays - 1) < 1e-9);
    for (uint32_t i = 0; i < RAYS; i++) {
        const struct draws draws = { 1, i };
        double u[2];
        draw_pair(&draws, 0, u);
        vec3 way = aim_way(&aim, &aim.disc[0], u);
        aimed += 1 / aim_density(&aim, way) / RAYS;
        even += (aim_density(&aim, warp_sphere(u)) > 0) * 4 * WARP_PI / RAYS;
    }
    assert_true(aimed > 0.005 && fabs(aimed - even) < 0.05 * even);
}

/* About as many rays in all as are wanted; none to what faces away. */
static void shares_the_rays(void **state)
{
    struct bright_hit hits[HITS];
    struct aim aim;
    (void)state;
    floor_hits(hits, 10);
    struct bright bright = bright_of(hits, HITS);
    for (uint32_t rays = 1; rays < 1024; rays *= 4) {
        aim_take(&aim, &bright, vec3_make(2, 2, 7), rays);
        double sum = 0;
        for (int i = 0; i < aim.count; i++) {
            assert_true(aim.disc[i].rays > 0);
            assert_true(aim.disc[i].rays <= AIM_RAYS_MOST);
            sum += aim.disc[i].rays;
        }
        assert_true(fabs(sum - aim.rays) < 1e-9 && sum <= rays + 1e-9);
    }
    aim_take(&aim, &bright, vec3_make(2, -2, 7), 64);
    assert_int_equal(aim.count, 0);
}

/* What another picture of an animation finds to be somewhat brighter is aimed
 * at by as many rays, and what is hardly bright by few more than none. */
static void keeps_the_rays(void **state)
{
    struct bright_hit hits[HITS];
    struct aim before, after;
    (void)state;
    floor_hits(hits, 10);
    for (int i = 0; i < HITS; i++)
        if (hits[i].origin.x > 9 && hits[i].origin.z > 9)
            hits[i].light = 4;
    struct bright bright = bright_of(hits, HITS);
    aim_take(&before, &bright, vec3_make(2, 2, 7), 64);
    for (int i = 0; i < HITS; i++)
        if (hits[i].origin.x > 9 && hits[i].origin.z > 9)
            hits[i].light = 6;
    bright = bright_of(hits, HITS);
    aim_take(&after, &bright, vec3_make(2, 2, 7), 64);
    assert_true(before.count > 1);
    assert_true(fabs(after.rays - before.rays) < 1e-9);
    for (int i = 0; i < before.count; i++) {
        bool found = false;
        for (int k = 0; k < after.count; k++)
            found |= after.disc[k].key == before.disc[i].key &&
                     fabs(after.disc[k].rays - before.disc[i].rays) < 1e-6;
        assert_true(found);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_patch),
        cmocka_unit_test(finds_none_where_all_is_alike),
        cmocka_unit_test(aims_as_often_as_it_says),
        cmocka_unit_test(aims_at_the_window),
        cmocka_unit_test(shares_the_rays),
        cmocka_unit_test(keeps_the_rays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
