/* The path tracer's parts: draws that are as even as they should be, maps of
 * the square whose densities are true, lobes whose densities sum to 1. */
#include "harness.h"

#include "base/draw.h"
#include "base/warp.h"
#include "scene/material.h"
#include "scene_world.h"
#include "tracer/lobes.h"

enum { NET = 256, STEPS = 400 };

/* 256 pairs, one in each of 256 boxes, whatever the boxes' shape. */
static void pairs_are_nets(void **state)
{
    (void)state;
    for (uint32_t slot = 0; slot < 20; slot++)
        for (int wide = 0; wide <= 8; wide++) {
            bool seen[NET] = { false };
            int columns = 1 << wide, rows = NET / columns;
            for (uint32_t i = 0; i < NET; i++) {
                struct draws draws = { 12345, i };
                double u[2];
                draw_pair(&draws, slot, u);
                int box = (int)(u[0] * columns) * rows + (int)(u[1] * rows);
                assert_in_range(box, 0, NET - 1);
                assert_false(seen[box]);
                seen[box] = true;
            }
        }
}

/* The correlation of two slots is noise: about 1/sqrt(n), over many keys. */
static void slots_are_independent(void **state)
{
    double squares = 0;
    (void)state;
    for (uint64_t key = 0; key < 200; key++) {
        double sum = 0;
        for (uint32_t i = 0; i < 1024; i++) {
            struct draws draws = { random_mix(key), i };
            sum += 12 * (draw_unit(&draws, 1) - 0.5) *
                   (draw_unit(&draws, 2) - 0.5) / 1024;
        }
        squares += sum * sum / 200;
    }
    assert_true(sqrt(squares) < 2.0 / 32);
}

static void shares_are_found(void **state)
{
    double sums[] = { 1, 1, 4, 10 }, share;
    (void)state;
    assert_int_equal(draw_share(sums, 4, 0, &share), 0);
    assert_true(fabs(share - 0.1) < 1e-12);
    assert_int_equal(draw_share(sums, 4, 0.1, &share), 2);
    assert_int_equal(draw_share(sums, 4, 0.39, &share), 2);
    assert_true(fabs(share - 0.3) < 1e-12);
    assert_int_equal(draw_share(sums, 4, 0.999, &share), 3);
}

/* The integral over all directions, on a grid even in solid angle. */
static double integral(double (*density)(const void *, vec3), const void *of)
{
    double sum = 0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            double u[2] = { (i + 0.5) / STEPS, (j + 0.5) / STEPS };
            sum += density(of, warp_sphere(u));
        }
    return sum * 4 * WARP_PI / STEPS / STEPS;
}

static double power_density(const void *of, vec3 direction)
{
    const double *m = of;
    return warp_lobe_density(
        vec3_dot(vec3_normalise(vec3_make(1, 2, -2)), direction), *m);
}

static void lobe_densities_are_whole(void **state)
{
    double powers[] = { 0, 0.5, 1, 3, 40 };
    (void)state;
    for (size_t i = 0; i < sizeof powers / sizeof *powers; i++)
        assert_true(fabs(integral(power_density, &powers[i]) - 1) < 2e-3);
}

/* Drawn directions have the mean cosine of their density: (m + 1)/(m + 2). */
static void lobes_are_drawn_by_density(void **state)
{
    double powers[] = { 0, 0.5, 1, 3, 40 };
    vec3 axis = vec3_normalise(vec3_make(-1, 0.3, 0.2));
    (void)state;
    for (size_t k = 0; k < sizeof powers / sizeof *powers; k++) {
        double sum = 0, m = powers[k];
        for (uint32_t i = 0; i < 4096; i++) {
            struct draws draws = { 1, i };
            double u[2];
            draw_pair(&draws, 0, u);
            sum += vec3_dot(axis, warp_lobe(u, axis, m)) / 4096;
        }
        assert_true(fabs(sum - (m + 1) / (m + 2)) < 1e-3);
    }
}

static double surface_density(const void *of, vec3 direction)
{
    return lobes_density(of, direction);
}

static const struct finish finishes[] = {
    { .diffuse = 0.6, .brilliance = 1 },
    { .diffuse = 0.6, .diffuse_back = 0.3, .brilliance = 2 },
    { .diffuse = 0.5, .brilliance = 0.5 },
    { .diffuse = 0.3,
      .brilliance = 1,
      .phong = 0.2,
      .phong_size = 10,
      .specular = 0.4,
      .specular_albedo = true,
      .roughness = 0.1 },
};

/* A surface seen at a slant. */
static struct surface slanted(const struct intersection *at,
                              const struct finish *finish)
{
    struct surface surface = { .at = at, .count = 1 };
    surface.view = vec3_normalise(vec3_make(0.5, 0.2, 0.8));
    surface.normal = vec3_make(0, 0, 1);
    surface.layer[0] =
        (struct surface_layer){ .finish = finish,
                                .pigment = { .r = 0.8, .g = 0.4, .b = 0.2 },
                                .normal = surface.normal,
                                .weight = { 1, 1, 1 } };
    return surface;
}

/* Also that sampling gives the same light as summing over directions: without
 * highlights, which are of lamps alone. */
static void surfaces_scatter_what_they_answer(void **state)
{
    struct leaf_look look = { .looks_like = -1 };
    struct leaf leaf = { .look = &look };
    struct intersection at = { .leaf = &leaf };
    (void)state;
    for (size_t k = 0; k < sizeof finishes / sizeof *finishes; k++) {
        struct surface surface = slanted(&at, &finishes[k]);
        struct lobes lobes;
        lobes_fill(&lobes, &surface);
        assert_true(fabs(integral(surface_density, &lobes) - 1) < 5e-3);
        double summed = 0, drawn = 0;
        for (uint32_t i = 0; i < 65536; i++) {
            struct draws draws = { 9, i };
            double u[2];
            draw_pair(&draws, 0, u);
            vec3 d = warp_sphere(u);
            summed += surface_response(&surface, d, false).r * 4 / 65536;
            d = lobes_sample(&lobes, draw_unit(&draws, 1), u);
            double density = lobes_density(&lobes, d);
            drawn += surface_response(&surface, d, false).r /
                     (WARP_PI * density * 65536);
        }
        assert_true(fabs(drawn / summed - 1) < 1e-2);
    }
}

static void highlights_scatter_nothing(void **state)
{
    static const struct finish shiny = { .phong = 0.5,
                                         .phong_size = 20,
                                         .brilliance = 1 };
    struct leaf_look look = { .looks_like = -1 };
    struct leaf leaf = { .look = &look };
    struct intersection at = { .leaf = &leaf };
    struct surface surface = slanted(&at, &shiny);
    struct lobes lobes;
    (void)state;
    lobes_fill(&lobes, &surface);
    assert_int_equal(lobes.count, 0);
    assert_true(lobes.total == 0);
}

static const char two_rooms[] =
    "#default { finish { ambient 0 diffuse .7 } }\n"
    "camera { location <4.9, 1.2, .2> look_at <3.5, .6, 2> }\n"
    "light_source { <1, 1.5, .6>, <8, 7, 6> }\n"
    "light_source { <.4, .5, 2>, <1, 2, 3> }\n"
    "difference {\n"
    "box { <-.2, -.2, -.2>, <5.2, 2.2, 3.2> }\n"
    "box { <0, 0, 0>, <2, 2, 3> }\n"
    "box { <1.9, 0, 2>, <3.1, 1.6, 2.8> }\n"
    "box { <3, 0, 0>, <5, 2, 3> } pigment { rgb .8 } }\n";

/* Round a corner there are lobes towards the light, which the density knows:
 * with the wrong normalisation, (s + 2)/(2 pi), it would not sum to 1. */
static void guided_lobes_are_whole(void **state)
{
    struct scene_world *all = scene_world_new(two_rooms);
    struct lighting_options options = { .threads = 2 };
    all->scene->settings.skeleton.resolution = 48;
    struct guide *guide =
        guide_new(all->world, all->scene, &options, &all->diag);
    (void)state;
    assert_non_null(guide);
    for (int i = 0; i < 5; i++) {
        vec3 point = vec3_make(3.3 + 0.3 * i, 0, 0.5), up = { 0, 1, 0 };
        struct lobes lobes;
        lobes_fill_plate(&lobes, up);
        lobes_guide(&lobes, guide, point, up, false);
        assert_true(lobes.light > 0);
        assert_in_range(lobes.count, 2, 1 + GUIDE_TARGETS);
        double towards = 0, away = 0;
        for (int k = 1; k < lobes.count; k++) {
            assert_true(lobes.at[k].axis.y > 0);
            *(lobes.at[k].axis.x < 0 ? &towards : &away) += lobes.at[k].share;
        }
        /* By the opening; farther in the lit wall opposite is brighter. */
        assert_true(i > 0 || towards > 2 * away);
        assert_true(fabs(integral(surface_density, &lobes) - 1) < 2e-3);
        double drawn = 0;
        for (uint32_t k = 0; k < 65536; k++) {
            struct draws draws = { 9, k };
            double u[2];
            draw_pair(&draws, 0, u);
            vec3 d = lobes_sample(&lobes, draw_unit(&draws, 1), u);
            drawn +=
                fmax(d.y, 0) / (WARP_PI * lobes_density(&lobes, d) * 65536);
        }
        assert_true(fabs(drawn - 1) < 1e-2);
    }
    guide_free(guide);
    scene_world_free(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_are_nets),
        cmocka_unit_test(slots_are_independent),
        cmocka_unit_test(shares_are_found),
        cmocka_unit_test(lobe_densities_are_whole),
        cmocka_unit_test(lobes_are_drawn_by_density),
        cmocka_unit_test(surfaces_scatter_what_they_answer),
        cmocka_unit_test(highlights_scatter_nothing),
        cmocka_unit_test(guided_lobes_are_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
