/* Surfaces that glow, as lamps: how large a part of what is seen they are, by
 * what is picked of them, beside closed forms. */
#include "harness.h"

#include <math.h>

#include "base/draw.h"
#include "base/warp.h"
#include "scene_world.h"
#include "shade/emitters.h"

enum { PICKS = 4096 };

/* The solid angle of all that glows, seen from the origin: each direction that
 * is picked stands for one by its density. Along each way something must be
 * met, of which emitters_density says the same. */
static double seen(const char *text, bool strewn)
{
    struct scene_world *all = scene_world_new(text);
    struct emitters *emitters = emitters_new(all->world, strewn);
    const vec3 from = { 0, 0, 0 };
    double sum = 0;
    int picked = 0;
    for (uint32_t i = 0; i < PICKS && emitters_any(emitters); i++) {
        struct emitter_pick pick;
        struct intersection at;
        double u[2];
        draw_pair(&(struct draws){ 5, i }, 0, u);
        if (!emitters_pick(emitters, from, (i + 0.5) / PICKS, u, &pick))
            continue;
        const struct ray ray = { from, pick.direction };
        if (!world_closest(all->world, &ray, 0, RAY_REFLECTION, &at))
            continue;
        picked++;
        sum += 1 / pick.density;
        assert_true(at.leaf == pick.leaf);
        double same = emitters_density(emitters, from, ray.direction, &at);
        if (!(fabs(same / pick.density - 1) < 1e-3))
            fail_msg("%g, not %g", same, pick.density);
    }
    assert_true(!emitters_any(emitters) || picked > 0.99 * PICKS);
    emitters_free(emitters);
    scene_world_free(all);
    return sum / PICKS;
}

#define GLOW " pigment { rgb 1 } finish { emission 1 } "

/* Half the angle that something round is seen under. */
static double round_angle(double tangent)
{
    return 2 * WARP_PI * (1 - 1 / sqrt(1 + tangent * tangent));
}

static void near(const char *text, double wanted, double off)
{
    double is = seen(text, true);
    if (!(fabs(is / wanted - 1) < off))
        fail_msg("%s: %g, not %g", text, is, wanted);
}

/* Shapes with simple parts are picked exactly. */
static void test_patches(void **state)
{
    (void)state;
    near("disc { z * 4, z, 1" GLOW "}", round_angle(0.25), 0.01);
    near("sphere { z * 4, 1" GLOW "}", round_angle(1 / sqrt(15)), 0.01);
}

/* Others by points, also scaled unevenly: a tube seen from one end, an egg from
 * its tip (the tangent is b / sqrt(d^2 - a^2)), a ring with its hole. */
static void test_points(void **state)
{
    (void)state;
    near("cylinder { z * 4, z * 6, 0.5 scale <2, 2, 1>" GLOW "}",
         round_angle(0.25), 0.03);
    near("superellipsoid { <1, 1> scale <1, 1, 2> translate z * 6" GLOW "}",
         round_angle(1 / sqrt(36 - 4)), 0.03);
    near("torus { 1, 0.2 rotate x * 90 translate z * 20" GLOW "}",
         round_angle(1.2 / 20) - round_angle(0.8 / 20), 0.03);
}

/* One that tells a crossing at a time is searched behind each, and may be off
 * by a little. */
static void test_isosurface(void **state)
{
    (void)state;
    near("isosurface { function { x * x + y * y + z * z - 1 } "
         "contained_by { box { -1.1, 1.1 } } max_gradient 4 "
         "translate z * 4" GLOW "}",
         round_angle(1 / sqrt(15)), 0.06);
}

/* Nobody who wants it exactly has points; what has no end has none. */
static void test_chance(void **state)
{
    (void)state;
    assert_true(seen("cylinder { z * 4, z * 6, 0.5" GLOW "}", false) == 0);
    assert_true(seen("plane { z, -4" GLOW "}", true) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_patches),
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_isosurface),
        cmocka_unit_test(test_chance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
