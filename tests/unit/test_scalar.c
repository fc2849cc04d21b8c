/* --lighting paper: the paper's equations (1) to (8), each against a value
 * worked out by hand. Lamps a million units away are as far from everywhere, so
 * that means over mesh points are known; E = 1000001 / 2 gives E / phi1 = 0.5.
 */
#include "harness.h"

#include <math.h>

#include "lightmesh/gather.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/scalar.h"
#include "scene_world.h"

#include "pixel.h"

#define FAR     "light_source { <0, 1000000, 0> rgb 500000.5 } "
#define SLANTED "light_source { <0, 866025.4037844386, -500000> rgb 500000.5 } "
#define MATTE   "finish { ambient 0 diffuse 1 } "
#define PI      3.14159265358979323846

struct stage {
    struct scene_world *all;
    struct lamps lamps;
    struct worker worker;
    struct scalar_mesh *mesh;
};

static struct stage stage_new(const char *text)
{
    struct stage stage = { .all = scene_world_new(text) };
    stage.lamps = lamps_new(stage.all->world, stage.all->scene, 9, 0);
    stage.worker.scratch = arena_new(0);
    return stage;
}

/* The stage must stay where it is from here on. */
static void stage_mesh(struct stage *stage, int samples)
{
    struct direct_options options = { .lattice = { .spacing = 0.25 },
                                      .interpolation =
                                          interpolation_find("spherical"),
                                      .bytes = 4000000 };
    stage->mesh = scalar_mesh_new(&stage->lamps, &options, samples);
}

static void stage_free(struct stage *stage)
{
    scalar_mesh_free(stage->mesh);
    lamps_free(&stage->lamps);
    arena_free(stage->worker.scratch);
    scene_world_free(stage->all);
}

/* What a ray from `eye` meets, the intersection kept in *at. */
static struct surface stage_surface(const struct stage *stage, vec3 eye,
                                    vec3 direction, struct intersection *at)
{
    struct gather gather = { .lamps = &stage->lamps };
    struct ray ray = { eye, direction };
    struct surface surface;
    assert_true(world_closest(stage->all->world, &ray, 0, RAY_CAMERA, at));
    gather_surface(&gather, &ray, at, &surface);
    return surface;
}

static void assert_near(double seen, double wanted, double tolerance)
{
    if (!(fabs(seen - wanted) <= tolerance * fabs(wanted) + 1e-12))
        fail_msg("%.9g, not %.9g", seen, wanted);
}

static void assert_rgb(rgb seen, double r, double g, double b, double tolerance)
{
    assert_near(seen.r, r, tolerance);
    assert_near(seen.g, g, tolerance);
    assert_near(seen.b, b, tolerance);
}

/* (1): E1/(1+2) of the lamp above and E2/(1+4) of the one beside, which a wall
 * hides from the second place: there E1/(1+5) alone, at the distance 5. */
static void test_direct_light(void **state)
{
    struct stage stage = stage_new("light_source { <0, 3, 0> rgb <3, 1.5, 0> } "
                                   "light_source { <4, 1, 0> rgb <5, 0, 2.5> } "
                                   "box { <-2.1, -9, -9>, <-2, 1.4, 9> }");
    (void)state;
    stage_mesh(&stage, 0);
    assert_rgb(scalar_direct(stage.mesh, &stage.worker, vec3_make(0, 1, 0)), 2,
               0.5, 0.5, 1e-12);
    assert_rgb(scalar_direct(stage.mesh, &stage.worker, vec3_make(-4, 0, 0)),
               0.5, 0.25, 0, 1e-12);
    assert_rgb(scalar_direct(stage.mesh, &stage.worker, vec3_make(-3, 7, 0)),
               3 / 6.0 + 5 / (1 + sqrt(85)), 1.5 / 6, 2.5 / (1 + sqrt(85)),
               1e-12);
    stage_free(&stage);
}

/* (2)'s E/phi1 at y, and its direction. */
static void test_lamp_term(void **state)
{
    struct stage stage = stage_new("light_source { <3, 4, 0> rgb <6, 3, 1> }");
    vec3 direction;
    (void)state;
    rgb term =
        scalar_lamp(&stage.lamps.items[0], vec3_make(0, 0, 0), &direction);
    assert_rgb(term, 1, 0.5, 1 / 6.0, 1e-12);
    assert_near(direction.x, 0.6, 1e-12);
    assert_near(direction.y, 0.8, 1e-12);
    stage_free(&stage);
}

/* (3) is 0.5 everywhere on a plane, (7) adds Emiss. */
static void test_mean(void **state)
{
    struct stage stage = stage_new(
        FAR "plane { y, 0 pigment { rgb <1, 0.5, 0> } finish { ambient 0 "
            "emission 0.25 } }");
    struct intersection at;
    (void)state;
    stage_mesh(&stage, 0);
    struct surface surface =
        stage_surface(&stage, vec3_make(0.1, 1, 0.3), vec3_make(0, -1, 0), &at);
    assert_rgb(scalar_mean(stage.mesh, &stage.worker, &surface), 0.75, 0.625,
               0.5, 1e-4);
    assert_rgb(scalar_indirect_mean(stage.mesh, &stage.worker, &surface), 0, 0,
               0, 0);
    stage_free(&stage);
}

/* (4) above a plane with I~ = 0.5: half the sphere sees it, 2 pi 0.5. The mean
 * (5) of that is the same. */
static void test_indirect(void **state)
{
    struct stage stage = stage_new(FAR "plane { y, 0 " MATTE "}");
    struct intersection at;
    (void)state;
    stage_mesh(&stage, 64);
    rgb light =
        scalar_indirect(stage.mesh, &stage.worker, vec3_make(0, 1, 0), 7);
    assert_near(light.g, PI, 1e-4);
    struct surface surface =
        stage_surface(&stage, vec3_make(0.1, 1, 0.3), vec3_make(0, -1, 0), &at);
    light = scalar_indirect_mean(stage.mesh, &stage.worker, &surface);
    assert_near(light.g, PI, 1e-4);
    stage_free(&stage);
}

/* (4) inside a ball of emission 0.3 without lamps: 4 pi 0.3 anywhere. */
static void test_emission_gathered(void **state)
{
    struct stage stage =
        stage_new("sphere { 0, 3 finish { ambient 0 emission 0.3 } "
                  "pigment { rgb 1 } }");
    (void)state;
    stage_mesh(&stage, 10);
    rgb light =
        scalar_indirect(stage.mesh, &stage.worker, vec3_make(1, -1, 0), 3);
    assert_rgb(light, 4 * PI * 0.3, 4 * PI * 0.3, 4 * PI * 0.3, 1e-6);
    stage_free(&stage);
}

static rgb picture(const char *settings, const char *text)
{
    char whole[2048];
    struct pixel_options options = { .quality = 9, .lighting = "paper" };
    snprintf(whole, sizeof whole,
             "global_settings { light_mesh { density 4 "
             "interpolation spherical %s } } camera { location <0, 5, -5> "
             "look_at 0 angle 1 } %s",
             settings, text);
    return pixel_see(whole, options).colour;
}

/* (2) with the lamp 30 degrees from the normal: 0.5 0.5 cos 30 = 0.2165, times
 * the pigment; (6) adds kd 2 pi 0.5. (8): a mirror of 0.4 shows 0.7 as 0.28. */
static void test_picture(void **state)
{
    static const char plane[] =
        "plane { y, 0 pigment { rgb <1, 0.5, 0.2> } " MATTE "}";
    double direct = 0.25 * cos(PI / 6);
    char text[512];
    (void)state;
    snprintf(text, sizeof text, SLANTED "%s", plane);
    assert_rgb(picture("indirect off", text), direct, 0.5 * direct,
               0.2 * direct, 1e-4);
    double full = direct + PI;
    rgb seen = picture("indirect { samples 64 }", text);
    assert_rgb(seen, full, 0.5 * full, 0.2 * full, 1e-4);
    snprintf(text, sizeof text,
             SLANTED "%s disc { <0, 0.5, 0>, y, 9 pigment { rgb 1 } finish { "
                     "ambient 0 diffuse 0 reflection 0.4 } no_shadow } "
                     "disc { <0, 9, 0>, -y, 20 no_shadow pigment { rgb 1 } "
                     "finish { ambient 0 diffuse 0 emission 0.7 } }",
             plane);
    assert_rgb(picture("indirect off", text), 0.28, 0.28, 0.28, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_direct_light),
        cmocka_unit_test(test_lamp_term),
        cmocka_unit_test(test_mean),
        cmocka_unit_test(test_indirect),
        cmocka_unit_test(test_emission_gathered),
        cmocka_unit_test(test_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
