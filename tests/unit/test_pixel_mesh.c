/* lightmesh/irregular, lamp_sights, pixel_mesh and world/casters: what lamps
 * see of many points at once is what rays find one by one. */
#include "harness.h"

#include <math.h>
#include <string.h>

#include "lightmesh/pixel_mesh.h"
#include "lightmesh/stagger.h"
#include "shade/shadow.h"
#include "stage.h"

/* Leaves at random over a floor, a lamp among them, others in all directions;
 * the camera looks on from above. */
static const char leaves[] =
    "camera { location <0,6,-7> look_at 0 angle 60 }\n"
    "#declare S = seed(5);\n"
    "#macro P(A) <rand(S)-.5, rand(S)-.5, rand(S)-.5>*A #end\n"
    "mesh { triangle { <-60,-2,-9>, <60,-2,-9>, <0,-2,60> }\n"
    "#for (I,1,400) #declare C = P(5);\n"
    "triangle { C, C + P(.7), C + P(.7) } #end }\n"
    "light_source { <0,.1,.2> rgb .3 }\n"
    "#for (I,1,30) light_source { P(9) + 3*y rgb <.1,.2,.05> } #end\n";

/* Everything that is taken apart in its own way. */
static const char shapes[] =
    "camera { location <0,3,-8> look_at <0,1,0> angle 55 }\n"
    "plane { y, 0 rotate 3*z }\n"
    "sphere { <-2,1,0>, 1 } torus { 1, .3 translate <3,.5,0> }\n"
    "box { <.5,.2,-1>, <1.5,2,0> rotate 20*y }\n"
    "difference { box { <-1,.1,1>, <1,2.5,2> } "
    "             cylinder { <0,1.2,0>, <0,1.2,3>, .7 } }\n"
    "sphere { <3,1.6,0>, .5 no_shadow }\n"
    "mesh { triangle { <-1,.3,-2>, <1,.3,-2>, <0,2,-2> } rotate 10*x }\n"
    "light_source { <0,4,-3> rgb .5 looks_like { sphere { 0, .2 } } }\n"
    "light_source { <1,1.2,-3> rgb .5 spotlight point_at 0 falloff 40 }\n"
    "light_source { <-3,3,-1> rgb 1 fade_distance 1 fade_power 2 }\n"
    "light_source { <2,5,1> rgb <.1,.4,.2> shadowless }\n"
    "light_source { <0,1.2,1.5> rgb 1 } light_source { <0,-5,0> rgb 1 }\n";

/* A stage taken apart, and which lamps look at it. */
struct looks {
    struct stage stage;
    struct casters casters;
    bool takes[64];
};

static void looks_start(struct looks *looks, const char *text)
{
    stage_start(&looks->stage, text);
    assert_true(casters_new(&looks->casters, looks->stage.all->world));
    for (size_t i = 0; i < looks->stage.lamps.count; i++)
        looks->takes[i] = true;
}

static void looks_end(struct looks *looks)
{
    casters_free(&looks->casters);
    stage_end(&looks->stage);
}

static struct pixel_mesh *looks_mesh(struct looks *looks, int apart,
                                     unsigned threads)
{
    struct stage *stage = &looks->stage;
    struct pixel_mesh_options options = {
        .casters = &looks->casters,
        .lamps = &stage->lamps,
        .takes = looks->takes,
        .camera = &stage->all->scene->camera,
        .apart = apart,
    };
    return pixel_mesh_new(&options, &stage->hits, stage->pointers, threads);
}

/* The same by shadow rays. */
static struct facet_light stage_rays(struct stage *stage, vec3 point, vec3 side)
{
    struct facet_light sum = { { 0 }, { 0 }, { 0 } };
    for (size_t i = 0; i < stage->lamps.count; i++) {
        const struct lamp *lamp = &stage->lamps.items[i];
        struct lamp_target target = { .point = point };
        if (!lamp_look(lamp, lamp->light->location, point, &target.view) ||
            vec3_dot(target.view.direction, side) <= 0)
            continue;
        rgb share =
            lamps_share_point(&stage->lamps, lamp, &stage->workers[0], &target);
        rgb c = rgb_scale(rgb_mul(lamp->light->colour, share),
                          target.view.attenuation);
        vec3 d = target.view.direction;
        const double part[4] = { d.x, d.y, d.z, 1 };
        for (int k = 0; k < 4; k++) {
            sum.r[k] += (float)(part[k] * c.r);
            sum.g[k] += (float)(part[k] * c.g);
            sum.b[k] += (float)(part[k] * c.b);
        }
    }
    return sum;
}

static bool lights_agree(const struct facet_light *a,
                         const struct facet_light *b, float most)
{
    for (int k = 0; k < 4; k++)
        if (fabsf(a->r[k] - b->r[k]) > most ||
            fabsf(a->g[k] - b->g[k]) > most || fabsf(a->b[k] - b->b[k]) > most)
            return false;
    return true;
}

/* At every pixel all lamps are seen as by rays, but where a shadow's edge is
 * nearer than single precision can tell. */
static void expect_rays(const char *text, int edges_most)
{
    struct looks looks;
    struct stage *stage = &looks.stage;
    int all = 0, wrong = 0;
    looks_start(&looks, text);
    struct pixel_mesh *mesh = looks_mesh(&looks, 1, 1);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            struct stage_seen seen;
            struct facet_light light, rays;
            if (!stage_meet(stage, x, y, &seen))
                continue;
            assert_true(pixel_mesh_light(mesh, &seen.receiver, &light));
            rays = stage_rays(stage, seen.at.point, seen.receiver.side);
            wrong += !lights_agree(&light, &rays, 1e-3f);
            all++;
        }
    assert_int_equal(pixel_mesh_count(mesh), all);
    assert_in_range(all, WIDTH * HEIGHT / 2, WIDTH * HEIGHT);
    assert_in_range(wrong, 0, edges_most);
    pixel_mesh_free(mesh);
    looks_end(&looks);
}

static void test_triangles_as_by_rays(void **state)
{
    (void)state;
    expect_rays(leaves, 12);
}

static void test_shapes_as_by_rays(void **state)
{
    (void)state;
    expect_rays(shapes, 12);
}

/* All light at the pixels of an area, in their order. */
static void take_lights(const struct stage *stage,
                        const struct pixel_mesh *mesh, int left, int top,
                        int edge, struct facet_light *out)
{
    for (int y = top; y < top + edge; y++)
        for (int x = left; x < left + edge; x++, out++) {
            struct stage_seen seen;
            memset(out, 0, sizeof *out);
            if (stage_meet(stage, x, y, &seen))
                assert_true(pixel_mesh_light(mesh, &seen.receiver, out));
        }
}

/* Fewer points serve all pixels, and of a part of the picture, with its apron,
 * and for any number of threads, the same ones. */
static void test_parts_and_threads(void **state)
{
    enum { LEFT = 40, TOP = 30, EDGE = 10, APRON = FIRST_HITS_APRON };
    static struct facet_light whole[EDGE * EDGE], part[EDGE * EDGE];
    size_t before = (size_t)-1;
    (void)state;
    for (int apart = 1; apart <= 16; apart *= 2) {
        struct looks looks;
        struct stage *stage = &looks.stage;
        looks_start(&looks, leaves);
        assert_int_equal(stagger_apart(apart), apart);
        struct pixel_mesh *mesh = looks_mesh(&looks, apart, 1);
        assert_true(pixel_mesh_count(mesh) < before);
        before = pixel_mesh_count(mesh);
        take_lights(stage, mesh, LEFT, TOP, EDGE, whole);
        pixel_mesh_free(mesh);
        free(stage->hits.at);
        stage_look(stage, LEFT - APRON, TOP - APRON, EDGE + 2 * APRON,
                   EDGE + 2 * APRON);
        mesh = looks_mesh(&looks, apart, THREADS);
        take_lights(stage, mesh, LEFT, TOP, EDGE, part);
        pixel_mesh_free(mesh);
        assert_memory_equal(whole, part, sizeof whole);
        looks_end(&looks);
    }
}

/* What is said of a scene: 1: it can be taken apart. */
static bool takes(const char *text)
{
    struct scene_world *all = scene_world_new(text);
    struct casters casters;
    bool taken = casters_new(&casters, all->world);
    if (taken)
        casters_free(&casters);
    scene_world_free(all);
    return taken;
}

static void test_what_is_taken_apart(void **state)
{
    (void)state;
    assert_true(takes("plane { y, 0 } sphere { 0, 1 }"));
    assert_true(takes("sphere { 0, 1 pigment { rgbt 1 } no_shadow }"));
    assert_false(takes("sphere { 0, 1 pigment { rgbt .5 } }"));
    assert_false(takes("triangle { x, y, z pigment { rgbf .5 } }"));
    assert_false(takes("quadric { <1,0,1>, 0, 0, -1 }"));
    assert_false(takes("intersection { plane { y, 0 } plane { x, 0 } }"));
}

static void test_what_lamps_can(void **state)
{
    static const char *const lights[] = {
        "9*y rgb 1",
        "9*y spotlight point_at x",
        "9*y shadowless",
        "9*y fade_distance 1",
        "249*y",
        "251*y",
        "9*y parallel",
        "9*y cylinder point_at x",
        "9*y area_light x, y, 3, 3",
        "9*y media_attenuation on",
    };
    (void)state;
    for (int i = 0; i < 10; i++) {
        char text[200];
        snprintf(text, sizeof text, "light_source { %s }", lights[i]);
        struct scene_world *all = scene_world_new(text);
        struct lamps lamps = lamps_new(all->world, all->scene, 9, 0);
        struct casters casters;
        assert_true(casters_new(&casters, all->world));
        assert_int_equal(
            lamp_sights_take(&lamps, &lamps.items[0], &casters, 1e-3), i < 5);
        casters_free(&casters);
        lamps_free(&lamps);
        scene_world_free(all);
    }
}

/* Points that know each lamp say the same as those that know the sum. */
static void test_each_lamp(void **state)
{
    struct looks looks;
    struct stage *stage = &looks.stage;
    (void)state;
    looks_start(&looks, leaves);
    looks.takes[3] = false;
    struct pixel_mesh_options options = {
        .casters = &looks.casters,
        .lamps = &stage->lamps,
        .takes = looks.takes,
        .camera = &stage->all->scene->camera,
        .apart = 1,
        .each = true,
    };
    struct pixel_mesh *mesh =
        pixel_mesh_new(&options, &stage->hits, stage->pointers, 2);
    for (int y = 0; y < HEIGHT; y += 5)
        for (int x = 0; x < WIDTH; x += 5) {
            struct stage_seen seen;
            int wrong = 0;
            if (!stage_meet(stage, x, y, &seen))
                continue;
            for (size_t i = 0; i < stage->lamps.count; i++) {
                const struct lamp *lamp = &stage->lamps.items[i];
                struct lamp_target target = { .point = seen.at.point };
                bool shines = false;
                assert_int_equal(
                    pixel_mesh_sees(mesh, &seen.place, lamp, &shines), i != 3);
                lamp_look(lamp, lamp->light->location, seen.at.point,
                          &target.view);
                if (i == 3 ||
                    vec3_dot(target.view.direction, seen.receiver.side) <= 0)
                    continue;
                rgb share = lamps_share_point(&stage->lamps, lamp,
                                              &stage->workers[0], &target);
                wrong += shines != (share.r > 0);
            }
            assert_in_range(wrong, 0, 1);
            seen.place.grid[0] += 0.3;
            bool shines;
            assert_false(pixel_mesh_sees(mesh, &seen.place,
                                         &stage->lamps.items[0], &shines));
        }
    pixel_mesh_free(mesh);
    looks_end(&looks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_triangles_as_by_rays),
        cmocka_unit_test(test_shapes_as_by_rays),
        cmocka_unit_test(test_parts_and_threads),
        cmocka_unit_test(test_what_is_taken_apart),
        cmocka_unit_test(test_what_lamps_can),
        cmocka_unit_test(test_each_lamp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
