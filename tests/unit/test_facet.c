/* lightmesh/facet*: which triangles have mesh points of their own, what these
 * know of lamps, and what a surface takes from them. */
#include "harness.h"

#include <math.h>
#include <string.h>

#include "lightmesh/facet_mesh.h"
#include "lightmesh/light_tree.h"
#include "scene_world.h"

enum { LAMPS = 40 };

/* A scene under lamps that are all over a square, five above the floor. */
struct stage {
    struct scene_world *all;
    struct lamps lamps;
    struct light_tree *tree;
    struct worker worker;
};

static struct stage stage_new(const char *objects)
{
    static char text[1 << 14];
    struct stage stage;
    size_t used = (size_t)snprintf(text, sizeof text, "%s\n", objects);
    for (int i = 0; i < LAMPS; i++)
        used += (size_t)snprintf(
            text + used, sizeof text - used,
            "light_source { <%g, 5, %g> rgb <0.1, 0.2, 0.4> }\n",
            i % 8 * 1.3 - 4.5, (i / 8) * 1.7 - 3.5);
    stage.all = scene_world_new(text);
    stage.lamps = lamps_new(stage.all->world, stage.all->scene, 9, 0);
    stage.tree = light_tree_new(&stage.lamps, vec3_make(0, 0, 0), 10);
    stage.worker = (struct worker){ .scratch = arena_new(0) };
    return stage;
}

static void stage_free(struct stage *stage)
{
    arena_free(stage->worker.scratch);
    light_tree_free(stage->tree);
    lamps_free(&stage->lamps);
    scene_world_free(stage->all);
}

/* Unshadowed light on a floor, the red part. */
static double stage_light(const struct stage *stage, vec3 place)
{
    double sum = 0;
    for (size_t i = 0; i < stage->lamps.count; i++) {
        vec3 to = vec3_sub(stage->lamps.items[i].light->location, place);
        sum += fmax(to.y, 0) / vec3_length(to) * 0.1;
    }
    return sum;
}

static struct intersection look(const struct stage *stage, vec3 from, vec3 to)
{
    struct intersection at;
    struct ray ray = { from, vec3_normalise(vec3_sub(to, from)) };
    assert_true(world_closest(stage->all->world, &ray, 0, RAY_CAMERA, &at));
    return at;
}

static void test_alone(void **state)
{
    (void)state;
    struct stage stage =
        stage_new("mesh { triangle { <0,0,0>, <1,0,0>, <0,0,1> }"
                  "       triangle { <1,0,0>, <0,0,1>, <1,0,1> } }"
                  "triangle { <4,0,0>, <5,0,0>, <4,0,1> }"
                  "triangle { <4,0,0>, <5,0,0>, <4,0,-1> translate 3*x }"
                  "triangle { <7,0,0>, <7,0,9>, <6.5,0,9> }"
                  "smooth_triangle { <9,0,0>, y, <10,0,0>, x+y, <9,0,1>, y+z }"
                  "box { <-3,-1,-3>, <-2,0,-2> }");
    const double x[] = { 0.2, 0.8, 4.2, 7.2, 6.9, 9.2, -2.5 };
    const double z[] = { 0.2, 0.8, 0.2, -0.2, 5, 0.2, -2.5 };
    const bool found[] = { true, true, true, true, true, false, true };
    /* The fourth and fifth share the corner <7,0,0>. */
    const bool alone[] = { false, false, true, false, false, false, false };
    struct facets *facets = facets_new(stage.all->world);
    uint32_t seen = 0;
    for (int i = 0; i < 7; i++) {
        struct facet facet, same;
        vec3 place = vec3_make(x[i], 0, z[i]);
        struct intersection at =
            look(&stage, vec3_make(x[i] + 1, 3, z[i]), place);
        double u, v;
        assert_int_equal(facets_find(facets, &at, &facet), found[i]);
        if (!found[i])
            continue;
        assert_int_equal(facet.alone, alone[i]);
        assert_true(fabs(fabs(facet.normal.y) - 1) < 1e-12);
        assert_int_equal(seen >> facet.number & 1, 0);
        seen |= 1u << facet.number;
        assert_true(facets_at(facets, facet.number, &same));
        assert_memory_equal(&same.corner, &facet.corner, sizeof same.corner);
        facet_locate(&facet, place, &u, &v);
        vec3 back = facet_place(&facet, u, v);
        assert_true(vec3_length(vec3_sub(back, place)) < 1e-9);
        facet_locate(&facet, vec3_make(100, 0, 70), &u, &v);
        assert_true(u >= 0 && v >= 0 && u + v <= 1 + 1e-12);
    }
    struct facet none;
    assert_false(facets_at(facets, 1000, &none));
    facets_free(facets);
    stage_free(&stage);
}

static struct facet_light ask(const struct stage *stage,
                              const struct facet_lamps *lamps, int budget,
                              double dither)
{
    struct facet_light light = { { 0 }, { 0 }, { 0 } };
    struct facet_site site = { .place = { 0.1, 0, 0.2 },
                               .normal = { 0, 1, 0 },
                               .budget = budget,
                               .key = 1,
                               .dither = dither };
    struct worker worker = stage->worker;
    facet_lamps_ask(lamps, &worker, &site, &light);
    return light;
}

/* Where nothing stands between, few rays are as right as all. */
static void test_unshadowed(void **state)
{
    (void)state;
    struct stage stage = stage_new("triangle { <-9,0,-9>, <9,0,-9>, <0,0,9> }");
    struct facet_lamps *lamps = facet_lamps_new(&stage.lamps, stage.tree);
    double wanted = stage_light(&stage, vec3_make(0.1, 0, 0.2));
    vec3 up = { 0, 1, 0 };
    for (int budget = 5; budget <= 80; budget *= 2) {
        struct facet_light light = ask(&stage, lamps, budget, 0.3);
        rgb on = facet_light_irradiance(&light, up, up, 1);
        /* Systematic: the last ray may fall on this side of the end or not. */
        assert_true(fabs(on.r - wanted) < wanted * 1.01 / budget);
        assert_true(fabs(on.b - 4 * on.r) < 1e-4 * on.b);
        if (budget >= LAMPS)
            assert_true(fabs(on.r - wanted) < 1e-5 * wanted);
    }
    facet_lamps_free(lamps);
    stage_free(&stage);
}

/* Whatever is drawn, the mean is right. */
static void test_unbiased(void **state)
{
    (void)state;
    struct stage stage = stage_new("box { <0.5,1,-9>, <9,1.1,9> }"
                                   "sphere { <-1,2,0>, 0.5 }");
    struct facet_lamps *lamps = facet_lamps_new(&stage.lamps, stage.tree);
    struct facet_light all = ask(&stage, lamps, LAMPS, 0);
    double sum = 0, wanted = facet_light_amount(&all), least = HUGE_VAL;
    assert_true(wanted > 0);
    for (int i = 0; i < 1000; i++) {
        struct facet_light light = ask(&stage, lamps, 8, (i + 0.5) / 1000);
        sum += facet_light_amount(&light) / 1000;
        least = fmin(least, facet_light_amount(&light));
    }
    assert_true(fabs(sum - wanted) < 0.01 * wanted);
    assert_true(least < 0.99 * wanted);
    facet_lamps_free(lamps);
    stage_free(&stage);
}

/* One lamp's light follows the cosine of any normal; that of the whole
 * hemisphere, (1 + cos) / 2 of what is on the level. */
static void test_tilted(void **state)
{
    (void)state;
    vec3 up = { 0, 1, 0 }, to = vec3_normalise(vec3_make(1, 2, 0.5));
    vec3 normal = vec3_normalise(vec3_make(0.6, 1, -0.3));
    rgb from_there;
    struct facet_light one = { .r = { (float)to.x, (float)to.y, (float)to.z,
                                      1 } };
    struct facet_light sky = { .g = { 0, 0.5f, 0, 1 } };
    rgb light = facet_light_irradiance(&one, up, normal, 1);
    assert_true(fabs(light.r - vec3_dot(to, normal)) < 1e-6);
    light = facet_light_irradiance(&one, up, normal, 3);
    assert_true(fabs(light.r - pow(vec3_dot(to, normal), 3)) < 1e-6);
    light = facet_light_irradiance(&sky, up, normal, 1);
    assert_true(fabs(light.g - 0.5 * (1 + normal.y) / 2) < 1e-6);
    vec3 direction = facet_light_direction(&one, &from_there);
    assert_true(vec3_length(vec3_sub(direction, to)) < 1e-6);
    assert_true(fabs(from_there.r - 1) < 1e-6 && from_there.g == 0);
}

/* Along a line over triangles of all sizes and shapes the light is right and
 * doesn't jump; from below there is none. */
static void test_mesh(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        "triangle { <-9,0,-9>, <9,0,-9>, <0,0,9> }",
        "mesh { triangle { <-9,0,-9>, <9,0,-9>, <0,0,9> }"
        "       triangle { <-9,0,-9>, <9,0,-9>, <0,-9,-9> } }",
        "triangle { <-9,0,-0.1>, <9,0,-0.1>, <9,0,0.1> }",
        "triangle { <-0.2,0,-0.2>, <0.2,0,-0.2>, <0,0,0.2> }",
        "union { box { <-3.5,-1,-3>, <4,0,2> } sphere { -2*y, 1 } }",
        "box { <-0.8,-1,-0.4>, <0.5,0,0.7> }",
    };
    const double reach[] = { 3, 3, 5, 0.05, 3.4, 0.5 };
    for (int k = 0; k < 6; k++) {
        struct stage stage = stage_new(scenes[k]);
        const struct lattice lattice = { .spacing = 0.5, .near = 9.5 };
        struct facet_mesh *mesh =
            facet_mesh_new(&stage.lamps, stage.tree, &lattice, LAMPS, 1000000);
        double before = 0;
        for (int i = 0; i <= 500; i++) {
            vec3 place = vec3_make(reach[k] * (i / 250.0 - 1), 0, 0);
            if (k == 2)
                place.z = place.x / 180 - 0.05;
            struct intersection at = look(&stage, vec3_make(0, 9, 0), place);
            struct receiver receiver = { .point = at.point,
                                         .side = { 0, 1, 0 },
                                         .at = &at,
                                         .view = { .eye = { 0, 9, 0 } } };
            struct facet_light light;
            vec3 up = { 0, 1, 0 };
            assert_true(
                facet_mesh_light(mesh, &stage.worker, &receiver, &light));
            double on = facet_light_irradiance(&light, up, up, 1).r;
            double wanted = stage_light(&stage, place);
            assert_true(fabs(on - wanted) < 0.05 * wanted);
            assert_true(i == 0 || fabs(on - before) < 0.02 * wanted);
            before = on;
            receiver.side = vec3_make(0, -1, 0);
            assert_true(
                facet_mesh_light(mesh, &stage.worker, &receiver, &light));
            assert_true(facet_light_amount(&light) == 0);
        }
        facet_mesh_free(mesh);
        stage_free(&stage);
    }
}

/* A floor too large to have points as near to each other as they should be is
 * left to the lattice. */
static void test_too_large(void **state)
{
    (void)state;
    struct stage stage = stage_new("box { <-1e6,-1,-1e6>, <1e6,0,1e6> }");
    struct intersection at =
        look(&stage, vec3_make(0, 9, 0), vec3_make(1, 0, 0));
    struct lattice lattice = { .spacing = 0.5 };
    const struct receiver receiver = { .point = at.point,
                                       .side = { 0, 1, 0 },
                                       .at = &at };
    struct facet_light light;
    struct facet_mesh *mesh =
        facet_mesh_new(&stage.lamps, stage.tree, &lattice, LAMPS, 1000000);
    assert_false(facet_mesh_light(mesh, &stage.worker, &receiver, &light));
    facet_mesh_free(mesh);
    lattice.spacing = 5000;
    mesh = facet_mesh_new(&stage.lamps, stage.tree, &lattice, LAMPS, 1000000);
    assert_true(facet_mesh_light(mesh, &stage.worker, &receiver, &light));
    facet_mesh_free(mesh);
    stage_free(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_alone),    cmocka_unit_test(test_unshadowed),
        cmocka_unit_test(test_unbiased), cmocka_unit_test(test_tilted),
        cmocka_unit_test(test_mesh),     cmocka_unit_test(test_too_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
