/* Noise and what is made of it: numbers that POV-Ray 3.7 printed. */
#include "harness.h"

#include <stdlib.h>

#include "base/order.h"
#include "scene/cubes.h"
#include "scene/noise.h"

#define NEAR 1e-6

enum { POINTS = 6 };

static const vec3 points[POINTS] = {
    { 0.3, 0.4, 0.6 },
    { -7.25, 3.5, 11.125 },
    { 0, 0, 0 },
    { 4100.7, -5000.2, 12345.9 },
    { -0.001, 2.999, 10000 },
    { 31.4, -62.8, 0.5 },
};

static void check_row(const char *name, int i, double value, double expected)
{
    if (fabs(value - expected) > NEAR)
        fail_msg("%s, point %d: %.9f, not %.9f", name, i, value, expected);
}

/* f_noise_generator(x, y, z, generator) */
static void generators_are_povrays(void **state)
{
    (void)state;
    static const double expected[3][POINTS] = {
        { 0.461991252, 0.884677223, 0.056580500, 0.634192829, 0.740115424,
          0.709771728 },
        { 0.496915256, 0.703970439, 0.298322439, 0.581269200, 0.633156000,
          0.618291964 },
        { 0.692491749, 0.288132034, 0.511354305, 0.462857676, 0.489219873,
          0.635672994 },
    };
    static const char *const names[] = { "clipped", "scaled", "Perlin's" };
    for (int generator = 1; generator <= 3; generator++)
        for (int i = 0; i < POINTS; i++)
            check_row(names[generator - 1], i,
                      noise_value((enum noise_generator)generator, points[i]),
                      expected[generator - 1][i]);
}

/* vturbulence(2, 0.5, 1, point) */
static void vectors_are_povrays(void **state)
{
    (void)state;
    static const double x[POINTS] = { -0.038008748, 0.384677223, -0.443419500,
                                      0.134192829,  0.240115424, 0.209771728 };
    static const double y[POINTS] = { -0.158045202, -0.353290599, 0.361005500,
                                      0.004393499,  -0.326565043, 0.060651929 };
    static const double z[POINTS] = { -0.113106392, 0.054420632, -0.459716000,
                                      -0.121036047, 0.446461171, 0.029186164 };
    for (int i = 0; i < POINTS; i++) {
        vec3 noise = noise_vector(points[i]);
        check_row("x", i, noise.x, x[i]);
        check_row("y", i, noise.y, y[i]);
        check_row("z", i, noise.z, z[i]);
    }
}

/* Every pattern of noise at the first two points. */
static void patterns_are_povrays(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double expected[2];
    } rows[] = {
        { "bozo", { 0.496915256, 0.703970439 } },
        { "spotted", { 0.496915256, 0.703970439 } },
        { "bumps", { 0.496915256, 0.703970439 } },
        { "dents", { 0.122700686, 0.348869713 } },
        { "granite", { 0.318655443, 0.280864160 } },
        { "wrinkles", { 0.581309982, 0.703333460 } },
        { "agate", { 0.935176603, 0.713751652 } },
        { "crackle", { 0.314256065, 0.499231571 } },
        { "ripples", { 0.231832382, 0.604588071 } },
        { "waves", { 0.710323236, 0.541202497 } },
    };
    struct arena *arena = arena_new(0);
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        struct pattern pattern =
            pattern_new(arena, pattern_find(rows[row].name));
        for (int i = 0; i < 2; i++)
            check_row(rows[row].name, i, pattern_value(&pattern, points[i]),
                      rows[row].expected[i]);
    }
    arena_free(arena);
}

/* pattern { marble ramp_wave turbulence 1 } */
static void turbulence_is_povrays(void **state)
{
    (void)state;
    static const double expected[POINTS] = { 0.451352130, 0.141932399,
                                             0.190269605, 0.925027001,
                                             0.164951025, 0.806329985 };
    const struct turbulence turbulence = { { 1, 1, 1 }, 6, 0.5, 2 };
    for (int i = 0; i < POINTS; i++) {
        double x = points[i].x +
                   noise_turbulence(NOISE_SCALED, points[i], &turbulence);
        double cycles = fmod(x, 1.00001);
        check_row("marble", i, cycles < 0 ? cycles + 1 : cycles, expected[i]);
    }
}

static void noise_is_continuous(void **state)
{
    (void)state;
    for (int generator = 1; generator <= 3; generator++)
        for (int i = 0; i < 2000; i++) {
            vec3 p = { (i % 20) - 10, (i / 20 % 10) * 0.37, i / 200 };
            vec3 below = { p.x - 1e-7, p.y, p.z };
            double step = noise_value((enum noise_generator)generator, p) -
                          noise_value((enum noise_generator)generator, below);
            assert_true(fabs(step) < 1e-5);
        }
}

/* What is worked out at several places is what it is at each of them. */
static void several_are_as_one(void **state)
{
    (void)state;
    const vec3 odd[] = { { -0.0, 1e-300, -1e-300 },
                         { 3e9, -3e9, 0.5 },
                         { 0x1p31, -0x1p31, -0x1.00000001p31 },
                         { 1e12, -1e13, 1e300 },
                         { INFINITY, NAN, -INFINITY },
                         { 0x1p30, 0x1.fffffffep30, -0x1.ffffffffp30 } };
    for (int i = 0; i < 1000; i++) {
        struct spots spots = { 0 };
        double values[SPOTS_MAX], octaves[3 * SPOTS_MAX];
        for (int k = 0; k <= i % SPOTS_MAX; k++)
            spots_add(&spots, i % 7 ? vec3_make(sin(i) * i, i * 0.37, k - i)
                                    : odd[(i / 7 + k) % 6]);
        for (int g = NOISE_CLIPPED; g <= NOISE_PERLIN; g++) {
            enum noise_generator generator = (enum noise_generator)g;
            noise_values(generator, &spots, values);
            noise_octaves(generator, &spots, (struct octaves){ 3, 1, 1.7 },
                          octaves);
            for (int k = 0; k < spots.count; k++) {
                vec3 p = spots_at(&spots, k);
                assert_true(values[k] == noise_value(generator, p));
                p = vec3_scale(vec3_scale(p, 1.7), 1.7);
                double third = noise_value(generator, p);
                assert_true(octaves[2 * spots.count + k] ==
                            (g == NOISE_CLIPPED ? third : 2 * third - 0.5));
            }
        }
        vec3 vectors[3 * SPOTS_MAX];
        noise_vector_octaves(&spots, (struct octaves){ 3, 1, 1.7 }, vectors);
        for (int k = 0; k < spots.count; k++) {
            vec3 at = vectors[spots.count + k];
            vec3 second = noise_vector(vec3_scale(spots_at(&spots, k), 1.7));
            assert_true(at.x == second.x && at.y == second.y &&
                        at.z == second.z);
        }
    }
}

/* Waves look at several points one wave after the other, and at one point many
 * waves at once: to the same bit. */
static void waves_tilt_points_together(void **state)
{
    (void)state;
    struct noise_waves waves = { 1.3, 0.2, 10, true };
    for (int i = 0; i < 64; i++) {
        struct spots spots = { 0 };
        vec3 tilts[SPOTS_MAX], alone;
        for (int k = 0; k <= i % SPOTS_MAX; k++)
            spots_add(&spots, vec3_make(sin(i) * k, i * 0.37 - k, k * 0.2));
        waves.uneven = i % 3 != 0;
        waves.count = 1 + i;
        noise_waves_tilts(&waves, &spots, tilts);
        for (int k = 0; k < spots.count; k++) {
            const struct spots one = spots_of(spots_at(&spots, k));
            noise_waves_tilts(&waves, &one, &alone);
            assert_true(tilts[k].x == alone.x && tilts[k].y == alone.y &&
                        tilts[k].z == alone.z);
        }
    }
}

/* The lattice begins anew after 4096 planes, also where a plane's number has
 * more than 32 bits. */
static void lattice_is_periodic(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        vec3 p = { i / 64.0, 40 - i / 32.0, (i * 37 % 400) / 16.0 };
        double value = noise_value(NOISE_SCALED, p);
        for (int bits = 12; bits < 40; bits++) {
            double period = ldexp(i % 2 ? 1 : -1, bits);
            vec3 q = { p.x + period, p.y - period, p.z + 4096 };
            if (q.x - period == p.x && q.y + period == p.y)
                assert_true(noise_value(NOISE_SCALED, q) == value);
        }
    }
}

static void turbulence_octaves_are_limited(void **state)
{
    (void)state;
    struct turbulence turbulence = { { 1, 1, 1 }, 1, 0.5, 2 };
    vec3 p = { 0.3, 0.4, 0.7 };
    vec3 one = noise_vector_turbulence(p, &turbulence);
    turbulence.octaves = 0;
    vec3 none = noise_vector_turbulence(p, &turbulence);
    assert_true(one.x == none.x && one.x == noise_vector(p).x);
    turbulence.octaves = 10;
    double ten = noise_turbulence(NOISE_SCALED, p, &turbulence);
    turbulence.octaves = 2000000000;
    assert_true(noise_turbulence(NOISE_SCALED, p, &turbulence) == ten);
}

static void cubes_are_all_looked_at(void **state)
{
    (void)state;
    for (int i = 0; i < 3000; i++) {
        /* The same cubes again and again, and those of the same slot. */
        vec3 base = { i % 7 - 3, i % 5 * 16, i % 3 * 4096 - 2 };
        vec3 place = { i % 10 * 0.1, i % 11 / 11.0, i % 13 / 13.0 };
        double least[4] = { HUGE_VAL, HUGE_VAL, HUGE_VAL, 0 }, squares[3];
        for (int cube = 0; cube < 27; cube++) {
            vec3 step = { cube % 3 - 1, cube / 3 % 3 - 1, cube / 9 - 1 };
            vec3 cell = vec3_add(base, step);
            vec3 at = vec3_add(step, noise_cell_point(cell.x, cell.y, cell.z));
            vec3 way = vec3_sub(at, place);
            least[3] = vec3_dot(way, way);
            qsort(least, 4, sizeof *least, order_double);
        }
        cubes_nearest(base, place, squares);
        for (int k = 0; k < 3; k++)
            assert_true(squares[k] == least[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(generators_are_povrays),
        cmocka_unit_test(vectors_are_povrays),
        cmocka_unit_test(patterns_are_povrays),
        cmocka_unit_test(turbulence_is_povrays),
        cmocka_unit_test(noise_is_continuous),
        cmocka_unit_test(several_are_as_one),
        cmocka_unit_test(lattice_is_periodic),
        cmocka_unit_test(waves_tilt_points_together),
        cmocka_unit_test(turbulence_octaves_are_limited),
        cmocka_unit_test(cubes_are_all_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
