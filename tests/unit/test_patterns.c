/* Patterns, pigments, normals, image maps: values computed by hand from the
 * formulas and printed by POV-Ray 3.7. Those made of noise: test_noise.c. */
#include "harness.h"

#include "image/image.h"
#include "scene/image_map.h"
#include "scene/material.h"
#include "scene/noise.h"
#include "scene/orbit.h"

#include <stdlib.h>

#define NEAR 1e-9

static struct arena *arena;

static int setup(void **state)
{
    (void)state;
    arena = arena_new(0);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    arena_free(arena);
    return 0;
}

static struct pattern pattern_named(const char *name)
{
    const struct pattern_kind *kind = pattern_find(name);
    assert_non_null(kind);
    return pattern_new(arena, kind);
}

static void check(const char *name, vec3 point, double expected)
{
    struct pattern pattern = pattern_named(name);
    double value = pattern_value(&pattern, point);
    if (fabs(value - expected) > NEAR)
        fail_msg("%s at <%g, %g, %g> is %.12g, not %.12g", name, point.x,
                 point.y, point.z, value, expected);
}

static void values_are_povrays(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        vec3 point;
        double value;
    } rows[] = {
        { "gradient", { 0.1, 0, 0 }, 0.1 },
        { "gradient", { 1, 0, 0 }, 1 },
        { "gradient", { 1.3, 0, 0 }, 0.3 },
        { "gradient", { -0.25, 0, 0 }, 0.75 },
        { "gradient", { -2, 0, 0 }, 0.00001 },
        { "marble", { 0.3, 5, 5 }, 0.6 },
        { "marble", { 1.1, 0, 0 }, 0.19998 },
        { "wood", { 0, 0.3, 9 }, 0.6 },
        { "wood", { -3, 0.1, 0.2 }, 0.003272407921453 },
        { "onion", { -3, 0.1, 0.2 }, 0.008321791298265 },
        { "onion", { 0, 0, -1 }, 0 },
        { "spherical", { 0.6, 0, -0.3 }, 0.329179606750063 },
        { "spherical", { 0, 2, 0 }, 0 },
        { "cylindrical", { 0.3, 7, 0.4 }, 0.5 },
        { "planar", { 9, -0.25, 9 }, 0.75 },
        { "planar", { 0, 0, 0 }, 1 },
        { "boxed", { 0.1, -0.8, 0.2 }, 0.2 },
        { "radial", { 0, 0, 0 }, 0.25 },
        { "radial", { 1, 7, 0 }, 1 },
        { "radial", { -1, 0, 0 }, 0.5 },
        { "radial", { 0, 0, 1 }, 0.75 },
        { "radial", { 1, 0, -1 }, 0.12499 },
        { "leopard", { 0.2, 0, 0 }, 0.004385500333 },
        { "checker", { 0.5, 0, 0.5 }, 0 },
        { "checker", { 0.5, -1e-11, 0.5 }, 0 },
        { "checker", { 0.5, -1e-9, 0.5 }, 1 },
        { "checker", { -1.5, -2.5, 2.5 }, 1 },
        { "checker", { 1e20, 0.3, 0.4 }, 0 },
        { "brick", { 1, 1, 0.1 }, 1 },
        { "brick", { 7.6, 1, 0.1 }, 0 },
        { "brick", { 3.6, 4, 0.1 }, 0 },
        { "brick", { 7.6, 4, 0.1 }, 1 },
        { "brick", { 1, 2.7, 0.1 }, 0 },
        { "brick", { 1, 1, 2 }, 0 },
        { "hexagon", { 0, 5, 0 }, 0 },
        { "hexagon", { 0, 0, 0.867 }, 1 },
        { "hexagon", { 0, 0, -0.867 }, 2 },
        { "hexagon", { 1.5, 0, 0 }, 2 },
        { "hexagon", { 1.5, 0, -1e-9 }, 1 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        check(rows[i].name, rows[i].point, rows[i].value);
}

/* POV-Ray's values of gradient x at 0.25 and 0.6 for each wave form. */
static void waves_fold(void **state)
{
    (void)state;
    static const double expected[][2] = {
        { 0.25, 0.6 },         { 0.5, 0.8 },
        { 1, 0.206107373854 }, { 0.707106781187, 0.951056516295 },
        { 0.15625, 0.648 },    { 0.0625, 0.36 },
    };
    struct pattern pattern = pattern_named("gradient");
    pattern.exponent = 2;
    for (int wave = WAVE_RAMP; wave <= WAVE_POLY; wave++) {
        pattern.wave = (enum wave)wave;
        double first = pattern_value(&pattern, vec3_make(0.25, 0, 0));
        double second = pattern_value(&pattern, vec3_make(0.6, 0, 0));
        assert_true(fabs(first - expected[wave][0]) < NEAR);
        assert_true(fabs(second - expected[wave][1]) < NEAR);
    }
}

static void frequency_and_phase_cycle(void **state)
{
    (void)state;
    static const struct {
        double frequency, phase, x, value;
    } rows[] = {
        { 2, 0, 0.6, 0.19999 }, { -1, 0, 0.25, 0.75 },
        { 1, -0.25, 0, 0.75 },  { 1, 3.5, 0, 0.49997 },
        { 0, 0.7, 0.4, 0.4 },   { 0, 0, -0.25, 0.75 },
        { 0.5, 0, -1.5, 0.25 }, { 3, 0.5, 0.25, 0.24999 },
    };
    struct pattern pattern = pattern_named("gradient");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        pattern.frequency = rows[i].frequency;
        pattern.phase = rows[i].phase;
        vec3 point = { rows[i].x, 0, 0 };
        double value = pattern_value(&pattern, point);
        if (fabs(value - rows[i].value) > NEAR)
            fail_msg("row %zu: %.12g", i, value);
    }
}

static bool colour_is(colour c, double r, double g, double b)
{
    return fabs(c.r - r) < 1e-6 && fabs(c.g - g) < 1e-6 && fabs(c.b - b) < 1e-6;
}

static struct pigment pigment_of(const char *name, const struct blend_map *map)
{
    struct pigment pigment = pigment_default(arena);
    pigment.kind = PIGMENT_PATTERN;
    pigment.pattern = pattern_named(name);
    pigment.map = map;
    return pigment;
}

/* At equal values the first entry ends the blend below, the last begins the
 * one above; outside of all the outermost colours go on. */
static void colour_map_is_looked_up_as_povrays(void **state)
{
    (void)state;
    struct blend_entry entries[] = {
        { 0.2, { 1, 0, 0, 0.1, 0.2 }, NULL }, { 0.5, { 0, 1, 0, 0, 0 }, NULL },
        { 0.5, { 9, 9, 9, 0, 0 }, NULL },     { 0.5, { 0, 0, 1, 0, 0 }, NULL },
        { 0.8, { 1, 1, 1, 0, 0 }, NULL },
    };
    const struct blend_map map = { entries, 5 };
    struct pigment pigment = pigment_of("gradient", &map);
    colour c = pigment_colour(&pigment, vec3_make(0.1, 0, 0));
    assert_true(colour_is(c, 1, 0, 0) && c.filter == 0.1 && c.transmit == 0.2);
    c = pigment_colour(&pigment, vec3_make(0.3, 0, 0));
    assert_true(colour_is(c, 2.0 / 3, 1.0 / 3, 0));
    c = pigment_colour(&pigment, vec3_make(0.5, 0, 0));
    assert_true(colour_is(c, 0, 1, 0));
    c = pigment_colour(&pigment, vec3_make(0.6, 0, 0));
    assert_true(colour_is(c, 1.0 / 3, 1.0 / 3, 1));
    c = pigment_colour(&pigment, vec3_make(0.95, 0, 0));
    assert_true(colour_is(c, 1, 1, 1));
    assert_false(pigment_is_opaque(&pigment));
}

static void patterns_without_map_have_defaults(void **state)
{
    (void)state;
    struct pigment marble = pigment_of("marble", NULL);
    vec3 vein = { 0.225, 0, 0 };
    assert_true(colour_is(pigment_colour(&marble, vein), 0.9, 0.44, 0.44));
    struct pigment grey = pigment_of("gradient", NULL);
    vec3 p = { 0.4, 0, 0 };
    assert_true(colour_is(pigment_colour(&grey, p), 0.4, 0.4, 0.4));
    struct pigment checker = pigment_of("checker", NULL);
    assert_true(colour_is(pigment_colour(&checker, p), 0, 0, 1));
    struct blend_entry one = { 0, { 0.1, 0.2, 0.3, 0, 0 }, NULL };
    const struct blend_map map = { &one, 1 };
    checker.map = &map;
    assert_true(colour_is(pigment_colour(&checker, p), 0.1, 0.2, 0.3));
    p.x = 1.4;
    assert_true(colour_is(pigment_colour(&checker, p), 0, 1, 0));
    assert_true(pigment_is_opaque(&checker));
}

/* The outer scale reaches the pigments inside. */
static void inner_pigments_move_with_the_outer(void **state)
{
    (void)state;
    struct pigment inner = pigment_of("onion", NULL);
    struct blend_entry entry = { 0, { 0 }, &inner };
    const struct blend_map map = { &entry, 1 };
    struct pigment outer = pigment_of("gradient", &map);
    affine scale = affine_scaling(vec3_make(3, 3, 3));
    const struct pigment *moved = pigment_moved(arena, &outer, &scale);
    colour c = pigment_colour(moved, vec3_make(1.2, 0, 0));
    assert_true(colour_is(c, 0.4, 0.4, 0.4));
}

/* Each of 100,000 levels holds the one before twice. */
static void pigments_nest_without_end(void **state)
{
    (void)state;
    const struct pigment *pigment = NULL;
    for (int i = 0; i < 100000; i++) {
        struct pigment *outer = ARENA_NEW(arena, struct pigment);
        struct blend_entry *entries = ARENA_ARRAY(arena, struct blend_entry, 2);
        struct blend_map *map = ARENA_NEW(arena, struct blend_map);
        entries[0] = (struct blend_entry){ 0, { 0 }, pigment };
        entries[1] = (struct blend_entry){ 1, { 0 }, pigment };
        *map = (struct blend_map){ entries, 2 };
        *outer = pigment_of("gradient", map);
        pigment = outer;
    }
    pigment_colour(pigment, vec3_make(0.5, 0, 0));
    assert_false(pigment_is_opaque(pigment));
}

static struct image *picture(void)
{
    struct image *image = image_new(4, 4);
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 4; x++) {
            float *p = image_pixel(image, x, y);
            p[0] = (float)x;
            p[1] = (float)y;
            p[3] = 1;
        }
    return image;
}

/* Column and row of the colour, counted from the top left. */
static void check_image(const struct image_map *map, vec3 point, double column,
                        double row)
{
    colour c = image_map_colour(map, point);
    if (fabs(c.r - column) > 1e-4 || fabs(c.g - row) > 1e-4)
        fail_msg("<%g, %g, %g>: column %g row %g", point.x, point.y, point.z,
                 c.r, c.g);
}

static void images_lie_as_povrays(void **state)
{
    (void)state;
    struct image *image = picture();
    struct image_map map = { .image = image };
    check_image(&map, vec3_make(0.1, 0.1, 3), 0, 3);
    check_image(&map, vec3_make(0.25, 0.76, 0), 1, 0);
    check_image(&map, vec3_make(-0.3, 1.3, 0), 2, 2);
    check_image(&map, vec3_make(-1e-20, -1e-20, 0), 0, 3);
    map.interpolation = IMAGE_BILINEAR;
    check_image(&map, vec3_make(0.125, 0.375, 0), 0, 2);
    check_image(&map, vec3_make(0.2, 0.375, 0), 0.3, 2);
    check_image(&map, vec3_make(0.05, 0.375, 0), 0.9, 2);
    check_image(&map, vec3_make(0.375, 0.05, 0), 1, 2.1);
    map.interpolation = IMAGE_NORMALISED_DISTANCE;
    check_image(&map, vec3_make(0.25, 0.375, 0), 0.5, 11.0 / 6);
    check_image(&map, vec3_make(0.2, 0.375, 0), 0.1840, 1.8922);
    check_image(&map, vec3_make(0.125, 0.375, 0), 0, 2);
    map.interpolation = IMAGE_BILINEAR;
    map.once = true;
    check_image(&map, vec3_make(0.05, 0.375, 0), 0, 2);
    assert_true(image_map_colour(&map, vec3_make(1, 0.5, 0)).transmit == 0);
    assert_true(image_map_colour(&map, vec3_make(1.1, 0.5, 0)).transmit == 1);
    image_free(image);
}

static void images_wrap_around_shapes(void **state)
{
    (void)state;
    struct image *image = picture();
    struct image_map map = { .image = image, .projection = IMAGE_SPHERICAL };
    check_image(&map, vec3_make(1, 0.1, 0.1), 0, 1);
    check_image(&map, vec3_make(-1, -0.1, -0.1), 2, 2);
    check_image(&map, vec3_make(0.1, 9, -1), 3, 0);
    check_image(&map, vec3_make(0, 1, 0), 0, 0);
    map.projection = IMAGE_CYLINDRICAL;
    check_image(&map, vec3_make(-0.1, 0.3, 1), 1, 2);
    map.projection = IMAGE_TORUS;
    check_image(&map, vec3_make(1.1, 1, 0.1), 0, 1);
    check_image(&map, vec3_make(0.5, -0.1, 0.1), 0, 3);
    image_free(image);
}

static void image_alpha_is_transmit(void **state)
{
    (void)state;
    struct image *image = picture();
    float *p = image_pixel(image, 0, 3);
    p[0] = 0.25f;
    p[3] = 0.5f;
    struct image_map map = { .image = image,
                             .filter_all = 0.125,
                             .transmit_all = 0.25 };
    colour c = image_map_colour(&map, vec3_make(0.1, 0.1, 0));
    assert_true(c.r == 0.25 && c.filter == 0.125 && c.transmit == 0.75);
    assert_false(image_map_is_opaque(&map));
    image_free(image);
}

static vec3 tilted(const char *name, double amount, const affine *transform,
                   vec3 point, vec3 normal)
{
    struct normal bumps = { pattern_named(name), amount, 0.02, NULL };
    if (transform)
        pattern_transform(&bumps.pattern, transform);
    return normal_perturbed(&bumps, point, normal, 0, NULL);
}

/* A slope of 1 with amount 1 tilts by 2/15, away from where it rises; scaled
 * evenly the tilt stays, stretched across the surface it grows. */
static void normals_tilt_as_povrays(void **state)
{
    (void)state;
    const vec3 front = { 0, 0, -1 }, p = { 0.355, 0.405, 0 };
    vec3 n = tilted("gradient", 1, NULL, p, front);
    assert_true(fabs(n.x / n.z - 2.0 / 15) < NEAR && n.z < 0);
    assert_true(fabs(vec3_length(n) - 1) < NEAR);
    n = tilted("gradient", 0.5, NULL, p, vec3_negate(front));
    assert_true(fabs(n.x / n.z + 1.0 / 15) < NEAR && n.z > 0);
    affine even = affine_scaling(vec3_make(2, 2, 2));
    n = tilted("gradient", 1, &even, p, front);
    assert_true(fabs(n.x / n.z - 2.0 / 15) < NEAR);
    affine uneven = affine_scaling(vec3_make(2, 3, 5));
    n = tilted("gradient", 1, &uneven, p, front);
    assert_true(fabs(n.x / n.z - 1.0 / 3) < NEAR);
    affine mirror = affine_scaling(vec3_make(-1, 1, 1));
    n = tilted("gradient", 1, &mirror, p, front);
    assert_true(fabs(n.x / n.z + 2.0 / 15) < NEAR && n.z < 0);
}

/* bumps, dents, wrinkles, ripples and waves have their own way: deviations
 * of the x component over a level surface with amount 0.2, POV-Ray's. */
static void special_normals_have_povrays_statistics(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double mean, deviation, tolerance;
    } rows[] = {
        { "bumps", -0.004, 0.048, 0.004 },   { "dents", 0, 0.010, 0.003 },
        { "wrinkles", 0.086, 0.036, 0.004 }, { "ripples", 0, 0.034, 0.006 },
        { "waves", 0, 0.085, 0.012 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double sum = 0, square = 0;
        enum { SIDE = 160 };
        for (int k = 0; k < SIDE * SIDE; k++) {
            vec3 p = { (k % SIDE) * 0.25 - 20, (k / SIDE) * 0.25 - 20, 0.3 };
            vec3 n = tilted(rows[i].name, 0.2, NULL, p, vec3_make(0, 0, -1));
            sum += n.x / (SIDE * SIDE);
            square += n.x * n.x / (SIDE * SIDE);
        }
        double deviation = sqrt(square - sum * sum);
        if (fabs(sum - rows[i].mean) > 0.006 ||
            fabs(deviation - rows[i].deviation) > rows[i].tolerance)
            fail_msg("%s: mean %g deviation %g", rows[i].name, sum, deviation);
    }
}

/* No scene can make a pattern give NaN or leave defined behaviour. */
static void patterns_survive_anything(void **state)
{
    (void)state;
    static const double extremes[] = { 0,      -1e-300, 1e-9,        0.5,
                                       -1.5,   1e10,    -1e18,       1e30,
                                       -1e154, 1e308,   (double)NAN, HUGE_VAL };
    enum { COUNT = sizeof extremes / sizeof *extremes };
    const struct pattern_kind *kind;
    for (size_t i = 0; (kind = pattern_at(i)); i++) {
        struct pattern pattern = pattern_new(arena, kind);
        struct normal normal = { pattern, 1e300, 0, NULL };
        for (int k = 0; k < COUNT * COUNT * COUNT; k++) {
            vec3 p = { extremes[k % COUNT], extremes[k / COUNT % COUNT],
                       extremes[k / COUNT / COUNT] };
            pattern.frequency = extremes[k % 7 + 3];
            pattern.phase = extremes[k % 5 + 5];
            pattern.turbulent = k % 2;
            pattern.turbulence =
                (struct turbulence){ p, k - 5, extremes[k % 10], 1e150 };
            pattern.wave = (enum wave)(k % 6);
            assert_true(isfinite(pattern_value(&pattern, p)));
            normal.pattern = pattern;
            vec3 n = normal_perturbed(&normal, p, vec3_make(0, 1, 0), 0, NULL);
            assert_true(fabs(vec3_length(n) - 1) < 1e-6);
        }
    }
}

/* To the bit, by every pattern, moved and warped, with slopes and without, in
 * any number. */
static void normals_together_are_as_alone(void **state)
{
    (void)state;
    static struct slope_entry slopes[] = { { 0, 0, 1 }, { 1, 0.4, -1 } };
    static const struct slope_map map = { slopes, 2 };
    const affine move = affine_scaling(vec3_make(0.3, -2, 1));
    const struct pattern_kind *kind;
    for (size_t i = 0; (kind = pattern_at(i)); i++)
        for (int k = 0; k < 16; k++) {
            struct normal normal = { .pattern = pattern_new(arena, kind),
                                     .amount = 0.7,
                                     .accuracy = 0.02,
                                     .slopes = k & 1 ? &map : NULL };
            if (kind->seen || kind->average)
                continue;
            normal.level = k & 2;
            normal.pattern.turbulent = k & 4;
            if (k & 8)
                pattern_transform(&normal.pattern, &move);
            struct spots points = { .count = 0 }, normals = points, together;
            for (int n = 0; n < k + 1; n++) {
                vec3 p = { 0.37 * n - 1, 0.71 * n, 0.29 - n };
                spots_add(&points, n == 5 ? vec3_make(1e300, 0, NAN) : p);
                spots_add(&normals, vec3_normalise(vec3_make(1, p.y, -p.x)));
            }
            normals_perturbed(&normal, &points, &normals, NULL, &together);
            for (int n = 0; n < points.count; n++) {
                vec3 alone = normal_perturbed(&normal, spots_at(&points, n),
                                              spots_at(&normals, n), 0, NULL);
                vec3 found = spots_at(&together, n);
                assert_memory_equal(&alone, &found, sizeof alone);
            }
        }
}

static void list_is_complete(void **state)
{
    (void)state;
    size_t count = 0;
    while (pattern_at(count)) {
        const struct pattern_kind *kind = pattern_at(count++);
        assert_ptr_equal(pattern_find(kind->name), kind);
        assert_non_null(kind->help);
        assert_true(!kind->defaults || kind->size > 0);
    }
    assert_int_equal(count, 44);
    assert_null(pattern_find("plaid"));
}

/* The orbit's last place, step by step; false if it leaves. */
static bool orbit_plainly(const struct orbit *orbit, double u, double v,
                          double last[2])
{
    double x = u, y = v;
    for (int i = 0; i < orbit->iterations; i++) {
        double a = x, b = y;
        for (int k = 1; k < orbit->exponent; k++) {
            double real = x * a - y * b;
            y = x * b + y * a;
            x = real;
        }
        x += u;
        y += v;
        if (x * x + y * y > 4)
            return false;
    }
    last[0] = x;
    last[1] = y;
    return true;
}

static double mandel_value(const struct orbit *orbit, double u, double v)
{
    const struct orbit_starts starts = { 1, { u }, { v }, { u }, { v } };
    double value;
    orbit_values(orbit, &starts, &value);
    return value;
}

/* Interior 2 is x of the last place, which a round too many would miss. */
static void orbits_may_leave_out_whole_rounds(void **state)
{
    int stayed = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        struct orbit orbit = {
            .iterations = 900 + i % 97,
            .exponent = 2 + i % 4,
            .exterior = { 1, 1 },
            .interior = { 2 + i % 2, 1 },
        };
        double u = i % 63 * 0.04 - 1.9, v = i / 63 * 0.03 - 0.95, last[2];
        if (!orbit_plainly(&orbit, u, v, last))
            continue;
        stayed++;
        assert_true(mandel_value(&orbit, u, v) == last[i % 2]);
    }
    assert_true(stayed > 500);
}

/* Pigments at many points, which end after more or fewer steps. */
static void pigments_of_many_points_are_those_of_each(void **state)
{
    static const char *const names[] = { "mandel", "julia", "magnet", "bozo",
                                         "checker" };
    (void)state;
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        struct pigment pigment = pigment_default(arena);
        pigment.kind = PIGMENT_PATTERN;
        pigment.pattern = pattern_new(arena, pattern_find(names[n]));
        if (n < 3) {
            struct orbit *orbit = pigment.pattern.parameters;
            orbit->iterations = 50;
            orbit->interior[0] = 3;
        }
        struct spots points = { .count = 0 };
        colour colours[SPOTS_MAX];
        for (int i = 0; i < SPOTS_MAX; i++)
            spots_add(&points, vec3_make(i * 0.21 - 2, i * 0.13 - 1, 0.3));
        for (; points.count > 0; points.count--) {
            pigment_colours(&pigment, &points, colours);
            for (int i = 0; i < points.count; i++) {
                colour alone = pigment_colour(&pigment, spots_at(&points, i));
                assert_memory_equal(&alone, &colours[i], sizeof alone);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_povrays),
        cmocka_unit_test(waves_fold),
        cmocka_unit_test(frequency_and_phase_cycle),
        cmocka_unit_test(colour_map_is_looked_up_as_povrays),
        cmocka_unit_test(patterns_without_map_have_defaults),
        cmocka_unit_test(inner_pigments_move_with_the_outer),
        cmocka_unit_test(pigments_nest_without_end),
        cmocka_unit_test(images_lie_as_povrays),
        cmocka_unit_test(images_wrap_around_shapes),
        cmocka_unit_test(image_alpha_is_transmit),
        cmocka_unit_test(normals_tilt_as_povrays),
        cmocka_unit_test(special_normals_have_povrays_statistics),
        cmocka_unit_test(patterns_survive_anything),
        cmocka_unit_test(orbits_may_leave_out_whole_rounds),
        cmocka_unit_test(pigments_of_many_points_are_those_of_each),
        cmocka_unit_test(normals_together_are_as_alone),
        cmocka_unit_test(list_is_complete),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
