/* scene/primitive: crossings at known places, and that crossings, insides,
 * normals and bounds tell the same story for every shape. */
#include "shapes.h"

#include "scene/mesh.h"
#include "scene/polynomial.h"

static const struct sample {
    const char *name;
    int count;
    double numbers[SHAPE_NUMBERS];
    bool closed; /* in and out alternate along every line */
} samples[] = {
    { "sphere", 4, { 0.1, 0.2, -0.3, 1.1 }, true },
    { "sphere", 4, { 0, 0, 0, -0.8 }, true },
    { "box", 6, { 1, 0.8, 1, -1, -0.7, -1.2 }, true },
    { "cylinder", 7, { -0.5, -1, 0.2, 0.3, 1, 0.5, 0.7 }, true },
    { "cone", 8, { -0.5, -1, 0.2, 1, 0.3, 1, 0.5, 0.3 }, true },
    { "cone", 8, { 0, -1, 0, 1, 0, 1, 0, 0 }, true },
    { "plane", 4, { 0.3, -2, 0.2, 0.3 }, true },
    { "plane", 4, { 0, 2, 0, 0.5 }, true },
    { "disc", 8, { 0.1, 0, 0, 0.3, 1, 0.2, 1.2, 0.4 }, false },
    { "torus", 2, { 1, 0.4 }, true },
    { "torus", 2, { 1.5, 0.02 }, true },
    { "torus", 2, { 0, 1 }, true },
    { "quadric", 10, { 1, 0.5, 2, 0.1, 0.2, 0.3, 0.1, -0.2, 0.1, -1 }, true },
    { "quadric", 10, { 1, -0.5, 2, 0.1, 0.2, 0.3, 0.1, 0, 0.1, -0.2 }, true },
    { "quadric", 10, { 1, 0, 1, 0, 0, 0, 0, 0, 0, -0.5 }, true },
    { "quadric", 10, { 1, 0, 1, 0, 0, 0, 0, -1, 0, 0 }, true },
    { "cubic",
      20,
      { 0.3, -0.2, 0.1,  0.4, 0.2, -0.5, 0.3, 0.2, 0.1, -0.3,
        0.4, 0.2,  -0.1, 0.6, 0.3, -0.2, 0.5, 0.1, 0.2, -0.4 },
      true },
    { "quartic",
      35,
      { 1, 0, 0, 0, 2, 0, 0, 2,    0, -2.32, 0, 0, 0, 0, 0,     0, 0,     0,
        0, 0, 1, 0, 0, 2, 0, 1.68, 0, 0,     0, 0, 1, 0, -2.32, 0, 0.7056 },
      true },
    { "poly", 11, { 2, 1, 0, 0, 0, 1, 0, 0, 1, 0, -1 }, true },
    { "superellipsoid", 2, { 1, 1 }, true },
    { "superellipsoid", 2, { 0.1, 0.3 }, true },
    { "superellipsoid", 2, { 1.8, 0.02 }, true },
    { "superellipsoid", 2, { 2.5, 0.6 }, true },
    { "polygon",
      30,
      { -1,  -1,  0, 1,  -1,  0, 1,  1,  0, -1,  1,  0, -1,  -1,  0,
        -.5, -.5, 0, .5, -.5, 0, .5, .5, 0, -.5, .5, 0, -.5, -.5, 0 },
      false },
};

enum { SAMPLES = sizeof samples / sizeof *samples, RAYS = 2000 };

static void sort_hits(struct hits *hits)
{
    for (int i = 1; i < hits->count; i++)
        for (int k = i; k > 0 && hits->at[k].t < hits->at[k - 1].t; k--) {
            struct hit swap = hits->at[k];
            hits->at[k] = hits->at[k - 1];
            hits->at[k - 1] = swap;
        }
}

/* The crossings cut the line into pieces that are in and out by turns. Short
 * pieces are within the tolerance of some inside tests. */
static void check_parity(const struct primitive *primitive, const void *shape,
                         const struct ray *ray, const struct hits *hits)
{
    bool first = false, known = false;
    for (int i = 0; i <= hits->count; i++) {
        double low = i > 0 ? hits->at[i - 1].t : -1e3;
        double high = i < hits->count ? hits->at[i].t : 1e3;
        if (high - low < 0.1)
            continue;
        vec3 middle = ray_point(ray, (low + high) / 2);
        bool turned = primitive->inside(shape, middle) == (i % 2 == 0);
        if (known)
            assert_true(turned == first);
        first = turned;
        known = true;
    }
}

/* A small step along the normal leads out, a step against it in. (Not where a
 * cubic's gradient is as small as the tolerance of its inside test.) */
static bool normal_is_good(const struct primitive *primitive, const void *shape,
                           const struct ray *ray, const struct hit *hit)
{
    vec3 p = ray_point(ray, hit->t);
    vec3 gradient = primitive->normal(shape, &p, hit);
    vec3 n = vec3_normalise(gradient);
    assert_true(fabs(vec3_length(n) - 1) < 1e-9);
    if (vec3_length(gradient) < 0.2)
        return true;
    bool outer = primitive->inside(shape, vec3_along(p, n, 1e-3));
    bool inner = primitive->inside(shape, vec3_along(p, n, -1e-3));
    return inner && !outer;
}

static void crossings_insides_and_normals_agree(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct dice dice = { 1 };
    for (int s = 0; s < SAMPLES; s++) {
        const struct sample *sample = &samples[s];
        const struct primitive *primitive = primitive_find(sample->name);
        void *shape =
            shape_new(arena, sample->name, sample->numbers, sample->count);
        struct box3 box = primitive->bounds(shape);
        vec3 more = { 1e-9, 1e-9, 1e-9 };
        box =
            (struct box3){ vec3_sub(box.low, more), vec3_add(box.high, more) };
        int met = 0, bad = 0;
        for (int i = 0; i < RAYS; i++) {
            struct ray ray = dice_ray(&dice);
            struct hits hits = { .count = 0 };
            primitive->intersect(shape, &ray, &hits);
            sort_hits(&hits);
            met += hits.count > 0;
            for (int k = 0; k < hits.count; k++) {
                vec3 p = ray_point(&ray, hits.at[k].t);
                assert_true(box3_contains(box, p));
                bool turned = sample->numbers[3] < 0 && s == 1;
                if (sample->closed && !turned)
                    bad += !normal_is_good(primitive, shape, &ray, &hits.at[k]);
            }
            if (sample->closed)
                check_parity(primitive, shape, &ray, &hits);
        }
        assert_true(met > 10);
        assert_true(bad <= met / 200);
    }
    arena_free(arena);
}

/* From a million units away as from near by: no digits are lost. */
static void far_rays_hit_the_same_points(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct dice dice = { 2 };
    for (int s = 0; s < SAMPLES; s++) {
        const struct primitive *primitive = primitive_find(samples[s].name);
        void *shape = shape_new(arena, samples[s].name, samples[s].numbers,
                                samples[s].count);
        for (int i = 0; i < 200; i++) {
            struct ray near = dice_ray(&dice), far = near;
            far.origin = ray_point(&near, -1e5);
            struct hits a = { .count = 0 }, b = { .count = 0 };
            primitive->intersect(shape, &near, &a);
            primitive->intersect(shape, &far, &b);
            if (a.count != b.count || a.count == 0)
                continue; /* grazing */
            sort_hits(&a);
            sort_hits(&b);
            double error = fabs(b.at[0].t - a.at[0].t - 1e5);
            vec3 p = ray_point(&near, a.at[0].t);
            vec3 n = vec3_normalise(primitive->normal(shape, &p, &a.at[0]));
            if (fabs(vec3_dot(n, near.direction)) > 0.1)
                assert_true(error < 1e-7);
        }
    }
    arena_free(arena);
}

/* No point of the inside and of the box is left out. */
static void quadrics_are_narrowed_safely(void **state)
{
    (void)state;
    const struct primitive *quadric = primitive_find("quadric");
    struct arena *arena = arena_new(0);
    struct dice dice = { 5 };
    int narrower = 0;
    for (int trial = 0; trial < 500; trial++) {
        double numbers[10], low[3], high[3];
        for (int i = 0; i < 10; i++)
            numbers[i] = dice_between(&dice, 0, 1) < 0.4
                             ? 0
                             : dice_between(&dice, -1, 1);
        for (int i = 0; i < 3; i++) {
            low[i] = dice_between(&dice, -2, 0);
            high[i] = dice_between(&dice, 0, 2);
            if (dice_between(&dice, 0, 1) < 0.4)
                low[i] = -HUGE_VAL;
            if (dice_between(&dice, 0, 1) < 0.4)
                high[i] = HUGE_VAL;
        }
        struct box3 box = { { low[0], low[1], low[2] },
                            { high[0], high[1], high[2] } };
        void *shape = shape_new(arena, "quadric", numbers, 10);
        struct box3 less = quadric->within(shape, box);
        narrower += box3_is_finite(less) && !box3_is_finite(box);
        less.low = vec3_sub(less.low, vec3_make(1e-9, 1e-9, 1e-9));
        less.high = vec3_add(less.high, vec3_make(1e-9, 1e-9, 1e-9));
        for (int i = 0; i < 500; i++) {
            vec3 p = dice_point(&dice, 4);
            if (box3_contains(box, p) && quadric->inside(shape, p))
                assert_true(box3_contains(less, p));
        }
    }
    assert_true(narrower > 20);
    arena_free(arena);
}

static void expect_hits(const char *name, const double *numbers, int count,
                        struct ray ray, int hit_count, const double *wanted)
{
    struct arena *arena = arena_new(0);
    void *shape = shape_new(arena, name, numbers, count);
    struct hits hits = { .count = 0 };
    primitive_find(name)->intersect(shape, &ray, &hits);
    sort_hits(&hits);
    assert_int_equal(hits.count, hit_count);
    for (int i = 0; i < hit_count; i++)
        assert_true(fabs(hits.at[i].t - wanted[i]) < 1e-12);
    arena_free(arena);
}

#define EXPECT(name, numbers, ray, ...)                                        \
    do {                                                                       \
        static const double given[] = numbers;                                 \
        static const double wanted[] = { __VA_ARGS__ };                        \
        expect_hits(name, given, sizeof given / sizeof *given, ray,            \
                    sizeof wanted / sizeof *wanted, wanted);                   \
    } while (0)
#define LIST(...)                                                              \
    {                                                                          \
        __VA_ARGS__                                                            \
    }

static void crossings_are_where_they_must_be(void **state)
{
    (void)state;
    struct ray x = { { -5, 0, 0 }, { 1, 0, 0 } };
    struct ray twice = { { -5, 0, 0 }, { 2, 0, 0 } };
    struct ray down = { { 0, 5, 0 }, { 0, -1, 0 } };
    EXPECT("sphere", LIST(0, 0, 0, 2), x, 3, 7);
    EXPECT("sphere", LIST(0, 0, 0, 2), twice, 1.5, 3.5);
    EXPECT("sphere", LIST(1e6, 0, 0, 1e4), x, 990005, 1010005);
    EXPECT("box", LIST(-1, -1, -1, 1, 1, 1), x, 4, 6);
    EXPECT("box", LIST(-1, 0, -1, 1, 0, 1), down, 5, 5);
    EXPECT("plane", LIST(0, 3, 0, 1), down, 4);
    EXPECT("cylinder", LIST(0, -1, 0, 0, 1, 0, 0.5), x, 4.5, 5.5);
    EXPECT("cylinder", LIST(0, -1, 0, 0, 1, 0, 0.5), down, 4, 6);
    EXPECT("cone", LIST(0, -1, 0, 1, 0, 1, 0, 0), x, 4.5, 5.5);
    EXPECT("torus", LIST(1, 0.25), x, 3.75, 4.25, 5.75, 6.25);
    EXPECT("disc", LIST(0, 1, 0, 0, 1, 0, 2), down, 4);
    EXPECT("quadric", LIST(1, 1, 1, 0, 0, 0, 0, 0, 0, -4), x, 3, 7);
    EXPECT("polygon", LIST(0, 1, -1, 0, -1, -1, 0, -1, 2, 0, 1, 2, 0, 1, -1), x,
           5);
}

static void expect_prepare(const char *name, const double *numbers, int count,
                           const char *problem, const char *warning)
{
    struct arena *arena = arena_new(0);
    const char *problem_said, *warning_said;
    shape_try(arena, name, numbers, count, &problem_said, &warning_said);
    if (problem)
        assert_string_equal(problem_said, problem);
    else
        assert_null(problem_said);
    if (warning)
        assert_string_equal(warning_said, warning);
    else
        assert_null(warning_said);
    arena_free(arena);
}

/* What POV-Ray 3.7 refuses, what it lets pass and doesn't draw. */
static void impossible_shapes_are_told(void **state)
{
    (void)state;
    static const double zeros[SHAPE_NUMBERS] = { 0 };
    static const double order[] = { 3, 1, 2, 3 };
    static const double bent[] = { 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 0 };
    static const double huge[] = { 36, 1 };
    expect_prepare("sphere", zeros, 4, NULL, NULL);
    expect_prepare("box", zeros, 6, NULL, NULL);
    expect_prepare("cylinder", zeros, 7, "its two ends are the same point",
                   NULL);
    expect_prepare("cone", zeros, 8, "its two ends are the same point", NULL);
    expect_prepare("plane", zeros, 4, "its normal has no direction", NULL);
    expect_prepare("disc", zeros, 8, NULL, "its normal has no direction");
    expect_prepare("torus", zeros, 2, NULL, NULL);
    expect_prepare("quadric", zeros, 10, NULL, NULL);
    expect_prepare("cubic", zeros, 7, "order 3 needs 20 terms, not 7", NULL);
    expect_prepare("poly", order, 4, "order 3 needs 20 terms, not 3", NULL);
    expect_prepare("poly", huge, 2, "its order is not within 2 and 35", NULL);
    expect_prepare("polygon", zeros, 6, "it needs at least three points", NULL);
    expect_prepare("polygon", zeros, 9, NULL, "its points are on one line");
    expect_prepare("polygon", bent, 12, NULL,
                   "its points are not in one plane");
}

/* Shapes that POV-Ray accepts although nothing is to be seen of them. */
static void empty_shapes_have_no_crossings(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int count;
        double numbers[10];
    } empty[] = {
        { "sphere", 4, { 0 } },
        { "torus", 2, { 1, 0 } },
        { "torus", 2, { -1, 0.25 } },
        { "cylinder", 7, { 0, -1, 0, 0, 1, 0, 0 } },
        { "disc", 8, { 0, 0, 0, 0, 0, 1, 1, 2 } },
        { "quadric", 10, { 0 } },
        { "quadric", 10, { 0, 0, 0, 0, 0, 0, 0, 0, 0, -1 } },
        { "quadric", 10, { 1, 1, 1, 0, 0, 0, 0, 0, 0, 1 } },
        { "poly", 11, { 2 } },
    };
    struct arena *arena = arena_new(0);
    struct dice dice = { 3 };
    for (size_t s = 0; s < sizeof empty / sizeof *empty; s++) {
        double numbers[SHAPE_NUMBERS] = { 0 };
        memcpy(numbers, empty[s].numbers, sizeof empty[s].numbers);
        void *shape = shape_new(arena, empty[s].name, numbers, empty[s].count);
        for (int i = 0; i < 200; i++) {
            struct ray ray = dice_ray(&dice);
            struct hits hits = { .count = 0 };
            primitive_find(empty[s].name)->intersect(shape, &ray, &hits);
            assert_int_equal(hits.count, 0);
        }
    }
    arena_free(arena);
}

static void polynomials_with_known_roots(void **state)
{
    (void)state;
    struct dice dice = { 4 };
    for (int trial = 0; trial < 500; trial++) {
        double c[POLYNOMIAL_DEGREE_MAX + 1] = { 1 }, wanted[8], found[8];
        int degree = 1 + trial % 8;
        for (int i = 0; i < degree; i++) {
            double root = i + dice_between(&dice, -0.4, 0.4) - degree / 2;
            wanted[i] = root;
            for (int k = i + 1; k > 0; k--)
                c[k] = c[k - 1] - root * c[k];
            c[0] *= -root;
        }
        double bound = polynomial_bound(c, degree);
        int count = polynomial_roots(c, degree, -bound, bound, found, 8);
        assert_int_equal(count, degree);
        for (int i = 0; i < degree; i++) {
            assert_true(fabs(wanted[i]) <= bound);
            assert_true(fabs(found[i] - wanted[i]) < 1e-8);
        }
    }
}

/* A closed fan around an axis: every ray that misses the rim crosses it once,
 * also rays exactly through the middle vertex or along edges. */
static void shared_edges_are_hit_once(void **state)
{
    (void)state;
    vec3 vertices[9] = { { 0, 0, 0 } };
    struct mesh_triangle triangles[8];
    for (uint32_t i = 0; i < 8; i++) {
        double angle = i * M_PI / 4;
        vertices[i + 1] = vec3_make(cos(angle), sin(angle), 0);
        triangles[i] = (struct mesh_triangle){ { 0, i + 1, (i + 1) % 8 + 1 },
                                               { MESH_NONE, 0, 0 },
                                               MESH_NONE };
    }
    struct mesh mesh = { .vertices = vertices,
                         .vertex_count = 9,
                         .triangles = triangles,
                         .triangle_count = 8 };
    assert_int_equal(mesh_prepare(&mesh), 0);
    for (int i = -5; i <= 5; i++)
        for (int j = -5; j <= 5; j++) {
            struct ray ray = { { i / 10.0, j / 10.0, -3 }, { 0, 0, 1 } };
            int count = 0;
            struct hit hit;
            for (size_t k = 0; k < 8; k++)
                count += mesh_intersect(&mesh, k, &ray, &hit);
            assert_int_equal(count, 1);
        }
}

static void meshes_drop_what_has_no_area(void **state)
{
    (void)state;
    vec3 vertices[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 } };
    vec3 normals[2] = { { 0, 0, 3 }, { 1, 0, 1 } };
    struct mesh_triangle triangles[4] = {
        { { 0, 1, 2 }, { MESH_NONE, 0, 0 }, MESH_NONE },
        { { 0, 1, 3 }, { 0, 0, 0 }, MESH_NONE },
        { { 0, 2, 3 }, { 0, 1, 0 }, MESH_NONE },
        { { 0, 2, 9 }, { 0, 1, 0 }, MESH_NONE },
    };
    struct mesh mesh = { .vertices = vertices,
                         .vertex_count = 4,
                         .normals = normals,
                         .normal_count = 2,
                         .triangles = triangles,
                         .triangle_count = 4 };
    assert_int_equal(mesh_prepare(&mesh), 2);
    assert_int_equal(mesh.triangle_count, 2);
    assert_true(mesh.triangles[0].normal[0] == MESH_NONE);
    assert_int_equal(mesh.triangles[1].normal[0], 0);
    assert_true(mesh.normals[0].z == 1);
    assert_true(mesh.bounds.high.x == 2 && mesh.bounds.high.y == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossings_insides_and_normals_agree),
        cmocka_unit_test(far_rays_hit_the_same_points),
        cmocka_unit_test(quadrics_are_narrowed_safely),
        cmocka_unit_test(crossings_are_where_they_must_be),
        cmocka_unit_test(impossible_shapes_are_told),
        cmocka_unit_test(empty_shapes_have_no_crossings),
        cmocka_unit_test(polynomials_with_known_roots),
        cmocka_unit_test(shared_edges_are_hit_once),
        cmocka_unit_test(meshes_drop_what_has_no_area),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
