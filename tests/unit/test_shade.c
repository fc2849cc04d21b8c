/* shade/: the formulas of surfaces, interiors, lamps and area lights, against
 * closed forms and numbers measured on POV-Ray 3.7. */
#include "harness.h"

#include <math.h>
#include <string.h>

#include "shade/area.h"
#include "shade/finish.h"
#include "shade/interior.h"
#include "shade/lamps.h"
#include "shade/media.h"

static void near(double value, double wanted)
{
    if (!(fabs(value - wanted) <= 1e-9 * (1 + fabs(wanted))))
        fail_msg("%.12g, not %.12g", value, wanted);
}

static void roughly(double value, double wanted)
{
    if (!(fabs(value - wanted) <= 3e-5))
        fail_msg("%.7g, not %.7g", value, wanted);
}

static void test_fresnel(void **state)
{
    (void)state;
    near(finish_fresnel(1, 1.5), 0.04);
    near(finish_fresnel(1, 1 / 1.5), 0.04);
    near(finish_fresnel(0, 1.5), 1);
    near(finish_fresnel(0.5, 1), 0);
    near(finish_fresnel(0.5, 1 / 1.5), 1); /* beyond the critical angle */
    roughly(finish_fresnel(0.5, 1.5), 0.0891867);
    near(finish_fresnel(0.5, 1e-300), 1);
}

static void test_metallic(void **state)
{
    (void)state;
    rgb p = { 0.3, 0.6, 0.9 };
    near(finish_metallic(0, 0.3, p).r, 1);
    roughly(finish_metallic(1, 1, p).r, 0.3);
    roughly(finish_metallic(1, 0, p).r, 1);
    /* 80 degrees, metallic 0.8, in a mirror of 0.72 (measured). */
    double cosine = cos(80 * 3.14159265358979 / 180);
    rgb tint = finish_metallic(0.8, cosine, p);
    roughly(tint.r * 0.72, 0.42208);
    roughly(tint.b * 0.72, 0.67744);
    near(finish_metallic(1, -0.1, p).g, 1); /* the curve is cut at 1 */
}

static void test_mirror(void **state)
{
    (void)state;
    struct finish finish = finish_default();
    finish.reflection.minimum = rgb_grey(0.2);
    finish.reflection.maximum = rgb_grey(0.9);
    finish.reflection.falloff = 2;
    struct finish_mirror mirror = finish_mirror(&finish, rgb_grey(1), 0.5, 1.5);
    near(mirror.colour.g, 0.2 + 0.7 * 0.25);
    near(mirror.weight, 0.9); /* as seen at the angle where it is strongest */
    finish.reflection.fresnel = true;
    mirror = finish_mirror(&finish, rgb_grey(1), 1, 1.5);
    near(mirror.colour.g, 0.2 + 0.7 * 0.04);
    near(mirror.weight, mirror.colour.g);
    finish.reflection.metallic = 1;
    mirror = finish_mirror(&finish, rgb_grey(0.5), 1, 1.5);
    assert_true(mirror.colour.g < mirror.weight);
    near(finish_exponent(rgb_grey(0.25), 2).r, 0.5);
    near(finish_exponent(rgb_grey(-1), 2).r, 0);
    near(finish_exponent(rgb_grey(-1), 1).r, -1);
}

/* A white, matt, half transparent layer seen along its normal -z. */
static struct surface_layer layer_of(const struct finish *finish)
{
    return (struct surface_layer){ .finish = finish,
                                   .weight = { 1, 1, 1 },
                                   .pigment = { 1, 1, 1, 0, 0.5 },
                                   .normal = { 0, 0, -1 } };
}

static double lit(const struct finish *finish, double x, double z, bool twice,
                  bool highlights)
{
    struct leaf_look look = { .double_illuminate = twice };
    struct leaf leaf = { .look = &look };
    struct intersection at = { .leaf = &leaf };
    struct surface surface = { .at = &at,
                               .view = { 0, 0, -1 },
                               .count = 1,
                               .layer = { layer_of(finish) } };
    struct light_sample sample = { vec3_normalise(vec3_make(x, 0, z)),
                                   rgb_grey(1), highlights };
    rgb sum = rgb_grey(0);
    surface_add_light(&surface, &sample, &sum);
    return sum.g;
}

static void test_light(void **state)
{
    (void)state;
    struct finish finish = finish_default();
    double c = 5 / sqrt(34.0);
    finish.diffuse = 0.6;
    near(lit(&finish, 0, -1, false, true), 0.3);
    near(lit(&finish, 3, -5, false, true), 0.3 * c);
    near(lit(&finish, 3, 5, false, true), 0);
    near(lit(&finish, 3, 5, true, true), 0.3 * c);
    finish.diffuse_back = 0.2;
    near(lit(&finish, 3, 5, false, true), 0.1 * c);
    near(lit(&finish, 3, 5, true, true), 0.3 * c);
    finish.brilliance = 3;
    near(lit(&finish, 3, -5, false, true), 0.3 * c * c * c);
    finish.diffuse_albedo = true;
    near(lit(&finish, 3, -5, false, true), 0.6 * c * c * c);
}

static void test_highlights(void **state)
{
    (void)state;
    struct finish finish = finish_default();
    double c = 5 / sqrt(34.0), half = cos(acos(c) / 2);
    finish.diffuse = 0;
    finish.phong = 0.1;
    finish.phong_size = 2;
    near(lit(&finish, 3, -5, false, true), 0.1 * c * c); /* not halved */
    near(lit(&finish, 3, -5, false, false), 0);
    near(lit(&finish, 3, 5, false, true), 0);
    finish.phong_albedo = true;
    near(lit(&finish, 3, -5, false, true), 0.15 * c * c);
    finish.phong = 0;
    finish.specular = 0.2;
    finish.roughness = 0.1;
    near(lit(&finish, 3, -5, false, true), 0.2 * pow(half, 10));
    finish.specular_albedo = true;
    near(lit(&finish, 3, -5, false, true),
         0.2 * pow(half, 10) * 12 / (4 * (2 - pow(2, -5))));
    finish.roughness = 0;
    near(lit(&finish, 3, -5, false, true), 0);
}

static void test_lit_by(void **state)
{
    (void)state;
    struct finish finish = finish_default();
    finish.diffuse = 0;
    assert_false(finish_lit_by(&finish, 1, false));
    finish.phong = 1;
    assert_true(finish_lit_by(&finish, 1, false));
    assert_false(finish_lit_by(&finish, -1, false));
    assert_true(finish_lit_by(&finish, -1, true));
    finish.diffuse_back = 0.1;
    assert_true(finish_lit_by(&finish, -1, false));
}

static void test_fade(void **state)
{
    (void)state;
    struct interior interior = interior_default();
    near(interior_fade(NULL, 5).r, 1);
    near(interior_fade(&interior, 5).r, 1);
    interior.fade_distance = 2;
    interior.fade_power = 2;
    interior.fade_colour = (rgb){ 0.5, 0.2, 1 };
    near(interior_fade(&interior, 1).r, 0.9);
    near(interior_fade(&interior, 1).g, 0.84);
    near(interior_fade(&interior, 1).b, 1);
    interior.fade_power = 1000;
    near(interior_fade(&interior, 1).r, exp(-0.25));
    near(interior_fade(&interior, 1).g, exp(-0.4));
    near(interior_fade(&interior, INFINITY).g, 0);
}

static void test_interiors(void **state)
{
    (void)state;
    struct interior glass = interior_default(), water = interior_default();
    glass.ior = 1.5;
    water.ior = 1.33;
    struct leaf_look looks[] = { { .interior = &glass, .hollow = true },
                                 { .interior = &water },
                                 { .interior = NULL } };
    struct leaf a = { .look = &looks[0], .body = 1 };
    struct leaf b = { .look = &looks[1], .body = 2 };
    struct leaf c = { .look = &looks[2], .body = 3 };
    struct interiors list = { .count = 0 };
    near(interiors_ior(&list), 1);
    assert_true(interiors_open(&list));
    interiors_cross(&list, &a);
    near(interiors_ior(&list), 1.5);
    assert_true(interiors_open(&list));
    interiors_cross(&list, &b);
    near(interiors_ior(&list), 1.33);
    assert_false(interiors_open(&list));
    interiors_cross(&list, &a); /* overlapping: the last entered still holds */
    near(interiors_ior(&list), 1.33);
    interiors_cross(&list, &c);
    near(interiors_ior(&list), 1);
    interiors_cross(&list, &c);
    interiors_cross(&list, &b);
    assert_int_equal(list.count, 0);
    for (unsigned i = 0; i < 1000; i++) {
        struct leaf leaf = { .look = &looks[2], .body = i };
        interiors_cross(&list, &leaf);
    }
    assert_int_equal(list.count, INTERIORS_MAX);
}

/* What arrives from a light at (x, y, -5) pointing at (px, 0, 0). */
static double arrives(struct light light, double x, double px)
{
    struct lamp_view view;
    light.location = vec3_make(x, 0, -5);
    light.point_at = vec3_make(px, 0, 0);
    struct lamp lamp = lamp_new(&light, 0);
    if (!lamp_look(&lamp, light.location, vec3_make(0, 0, 0), &view))
        return 0;
    return view.attenuation;
}

static void test_lamps(void **state)
{
    (void)state;
    struct light light = light_default();
    near(arrives(light, 0, 0), 1);
    light.fade_distance = 3;
    light.fade_power = 2;
    near(arrives(light, 0, 0), 2 / (1 + 25.0 / 9));
    light.fade_power = 0;
    light.kind = LIGHT_SPOT;
    light.radius = 20;
    light.falloff = 120;
    roughly(arrives(light, 4, 4), 0.96617);
    light.falloff = 10; /* narrower than the radius: the radius counts */
    near(arrives(light, 1, 1), 1);
    near(arrives(light, 4, 4), 0);
    light.tightness = 10;
    near(arrives(light, 1, 1), pow(5 / sqrt(26.0), 10));
    light.kind = LIGHT_CYLINDER;
    light.tightness = 0;
    light.radius = 2;
    light.falloff = 4;
    near(arrives(light, 1, 1), 1);
    near(arrives(light, 3, 3), 0.5);
    near(arrives(light, 5, 5), 0);
    light.tightness = 1;
    near(arrives(light, 3, 3), 0.125);
}

/* Rays along a cone's own side enter it where they do, and never leave it. */
static void test_media_parts(void **state)
{
    struct light light = light_default();
    light.kind = LIGHT_SPOT;
    light.radius = light.falloff = 45;
    light.point_at = vec3_make(0, -1, 0);
    struct lamp lamp = lamp_new(&light, 0);
    struct lamps lamps = { .items = &lamp, .count = 1 };
    struct media_list media = { .count = 1, .scatters = true };
    (void)state;
    for (int i = 1; i <= 100; i++) {
        double high = i * 0.07, wide = i % 10 * 0.3;
        struct media_way way = { .media = &media,
                                 .origin = { wide, high, -5 },
                                 .direction =
                                     vec3_normalise(vec3_make(0, -1, 1)),
                                 .length = 1000,
                                 .lamps = &lamps };
        struct media_part parts[MEDIA_PARTS_MAX];
        struct media_beams beams;
        /* wide^2 + (t - 5)^2 = (t - high)^2 */
        double t = (25 + wide * wide - high * high) / 2 / (5 - high);
        bool meets = high < 5;
        int count = media_parts(&way, &beams, parts);
        assert_int_equal(count, meets ? 2 : 1);
        assert_int_equal(parts[count - 1].lit, meets);
        assert_int_equal(beams.count, meets ? 1 : 0);
        if (meets)
            roughly(parts[1].from, t * sqrt(2));
    }
}

static void test_parallel(void **state)
{
    (void)state;
    struct light light = light_default();
    struct lamp_view view;
    light.parallel = true;
    light.location = vec3_make(7, 8, 5);
    light.point_at = vec3_make(7, 8, 10);
    struct lamp lamp = lamp_new(&light, 0);
    assert_true(lamp_look(&lamp, light.location, vec3_make(0, 0, 0), &view));
    near(view.direction.z, -1);
    near(view.distance, -5); /* behind the light's plane: no shadow */
}

/* The weight of each point of a row of n: what is seen if only it shines. */
struct only {
    double place;
    int asked;
};

static void only_one(void *context, const struct area_points *points, rgb *seen)
{
    struct only *only = context;
    only->asked += points->count;
    for (int k = 0; k < points->count; k++)
        seen[k] = rgb_grey(fabs(points->location[0][k] - only->place) < 1e-6);
}

static double weight_of(int n, int i)
{
    struct light light = light_default();
    light.area = true;
    light.adaptive = -1;
    light.axis1 = vec3_make(1, 0, 0);
    light.axis2 = vec3_make(0, 1, 0);
    light.size1 = n;
    light.size2 = 1;
    struct lamp lamp = lamp_new(&light, 0);
    struct area_grid grid = area_grid_new(&lamp, vec3_make(0, 0, 9), 0);
    struct only only = { area_grid_point(&grid, i, 0).x, 0 };
    return area_visibility(&grid, rgb_grey(1), only_one, &only).r;
}

static void test_area_weights(void **state)
{
    (void)state;
    static const double wanted[][10] = {
        { 2, 2 },
        { 4, 2, 4 },
        { 4, 4, 4, 4 },
        { 8, 4, 4, 4, 8 },
        { 8, 4, 8, 8, 4, 8 },
        { 8, 8, 8, 4, 8, 8, 8 },
        { 8, 8, 8, 8, 8, 8, 8, 8 },
        { 16, 8, 8, 8, 8, 8, 8, 8, 16 },
        { 16, 8, 8, 8, 16, 16, 8, 8, 8, 16 },
    };
    for (int n = 2; n <= 10; n++)
        for (int i = 0; i < n; i++)
            near(weight_of(n, i), 1 / wanted[n - 2][i]);
}

static void all_seen(void *context, const struct area_points *points, rgb *seen)
{
    struct only *only = context;
    only->asked += points->count;
    for (int k = 0; k < points->count; k++)
        seen[k] = rgb_grey(1);
}

/* Points looked at where nothing stands in the way, 17 x 17. */
static void test_area_adaptive(void **state)
{
    (void)state;
    static const int wanted[] = { 289, 4, 9, 25, 81, 289 };
    struct light light = light_default();
    light.area = true;
    light.axis1 = vec3_make(1, 0, 0);
    light.axis2 = vec3_make(0, 1, 0);
    light.size1 = light.size2 = 17;
    for (int k = -1; k <= 4; k++) {
        struct only only = { 0, 0 };
        light.adaptive = k;
        struct lamp lamp = lamp_new(&light, 0);
        struct area_grid grid = area_grid_new(&lamp, vec3_make(0, 0, 9), 0);
        near(area_visibility(&grid, rgb_grey(1), all_seen, &only).r, 1);
        assert_int_equal(only.asked, wanted[k + 1]);
    }
}

/* What lies on one side of a straight line is seen; what lies on the other has
 * another colour. */
struct edge {
    double across, along, limit;
    rgb beyond;
    int asked;
};

static void edge_seen(void *context, const struct area_points *points,
                      rgb *seen)
{
    struct edge *edge = context;
    edge->asked += points->count;
    for (int k = 0; k < points->count; k++) {
        double x = points->location[0][k], y = points->location[1][k];
        /* Coordinates say where the point is. */
        near(points->place[0][k] * 0.501, x);
        seen[k] = x * edge->across + y * edge->along < edge->limit
                      ? rgb_grey(1)
                      : edge->beyond;
    }
}

/* The share of the unit square before the line, by many thin strips. */
static double edge_truth(const struct edge *edge, bool line)
{
    double sum = 0;
    for (int k = 0; k < 2000; k++) {
        double y = line ? 0 : (k + 0.5) / 2000 - 0.5;
        double end = (edge->limit - y * edge->along) / edge->across;
        double left = fmin(fmax(end + 0.5, 0), 1);
        sum += edge->across > 0 ? left : 1 - left;
    }
    return sum / 2000;
}

static struct light unit_light(int columns, int rows, int adaptive)
{
    struct light light = light_default();
    light.area = true;
    light.axis1 = vec3_make(1, 0, 0);
    light.axis2 = vec3_make(0, 1, 0);
    light.size1 = columns;
    light.size2 = rows;
    light.adaptive = adaptive;
    return light;
}

static double outline_share(const struct light *light, area_visit *visit,
                            void *context)
{
    struct lamp lamp = lamp_new(light, 0);
    struct area_grid grid = area_grid_new(&lamp, vec3_make(0, 0, 9), 0);
    area_grid_refine(&grid);
    return area_outline(&grid, rgb_grey(1), true, visit, context).r;
}

/* Straight outlines, whatever their angle, are right to half a step, by far
 * fewer rays than the grid has points; of lights that are lines too. */
static void test_area_outline(void **state)
{
    (void)state;
    for (int trial = 0; trial < 300; trial++) {
        double angle = 0.1 * trial, slope = trial % 2 ? 0.7 * sin(angle) : 0;
        struct light light =
            unit_light(2 + trial % 32, 1 + trial % 5, trial % 2);
        struct edge edge = { trial % 3 ? 1 : -1, slope,
                             0.013 * (trial % 80) - 0.52,
                             rgb_grey(trial % 7 ? 0 : 0.25), 0 };
        double truth = edge_truth(&edge, light.size2 == 1);
        double beyond = edge.beyond.r;
        double seen = outline_share(&light, edge_seen, &edge);
        truth = truth + (1 - truth) * beyond;
        assert_true(fabs(seen - truth) <= 0.5 / AREA_FINE + 1e-3);
        assert_true(edge.asked <= 70);
    }
}

/* A pane before all of the light, that lets more pass to one side: no outline
 * is looked for, and no more points are asked than the author has written and
 * one between each four of them. */
static void through_pane(void *context, const struct area_points *points,
                         rgb *seen)
{
    struct only *only = context;
    only->asked += points->count;
    for (int k = 0; k < points->count; k++)
        seen[k] = rgb_grey(0.5 + 0.8 * points->location[0][k]);
}

static void test_area_outline_behind_pane(void **state)
{
    (void)state;
    for (int size = 3; size <= 9; size = 2 * size - 1) {
        struct light light = unit_light(size, size, -1);
        struct only pane = { 0 };
        assert_true(fabs(outline_share(&light, through_pane, &pane) - 0.5) <
                    1e-9);
        assert_true(pane.asked <= size * size + (size - 1) * (size - 1));
    }
}

/* And an outline of one pane behind another: right to half a step. */
static void through_panes(void *context, const struct area_points *points,
                          rgb *seen)
{
    const double *edge = context;
    for (int k = 0; k < points->count; k++)
        seen[k] = rgb_grey(points->location[0][k] < *edge ? 0.8 : 0.4);
}

static void test_area_outline_of_panes(void **state)
{
    (void)state;
    for (double edge = -0.45; edge < 0.5; edge += 0.05) {
        struct light light = unit_light(5, 5, -1);
        double seen = outline_share(&light, through_panes, &edge);
        assert_true(fabs(seen - (0.4 + 0.4 * (edge + 0.5))) <=
                    0.4 * (0.5 / AREA_FINE + 1e-3));
    }
}

/* A disc before the light, wider than the parts that are looked at. Chords
 * leave out some of it: less with every step of `adaptive` from 2 on. */
static void around_disc(void *context, const struct area_points *points,
                        rgb *seen)
{
    struct only *only = context;
    only->asked += points->count;
    for (int k = 0; k < points->count; k++)
        seen[k] = rgb_grey(hypot(points->location[0][k] - 0.05,
                                 points->location[1][k] + 0.1) >= only->place);
}

static void test_area_outline_of_disc(void **state)
{
    (void)state;
    static const double allowed[] = { 0.04, 0.04, 0.012, 0.004 };
    for (int adaptive = 1; adaptive <= 4; adaptive++) {
        struct light light = unit_light(9, 9, adaptive);
        for (double r = 0.16; r < 0.4; r += 0.01) {
            struct only only = { r, 0 };
            double seen = outline_share(&light, around_disc, &only);
            double error = seen - (1 - 3.14159265358979 * r * r);
            assert_true(fabs(error) < allowed[adaptive - 1]);
        }
    }
}

/* Rays that all see the same stay few, however fine the light's grid is. */
static void test_area_refined(void **state)
{
    (void)state;
    struct light light = unit_light(1000, 17, 1);
    struct only only = { 0, 0 };
    near(outline_share(&light, all_seen, &only), 1);
    assert_int_equal(only.asked, 25);
    light.size1 = light.size2 = 1;
    only.asked = 0;
    near(outline_share(&light, all_seen, &only), 1);
    assert_int_equal(only.asked, 1);
}

static void test_area_shapes(void **state)
{
    (void)state;
    struct light light = light_default();
    light.area = true;
    light.adaptive = -1;
    light.axis1 = vec3_make(4, 0, 0);
    light.axis2 = vec3_make(0, 4, 0);
    light.size1 = light.size2 = 2;
    light.circular = true;
    struct lamp lamp = lamp_new(&light, 0);
    struct area_grid grid = area_grid_new(&lamp, vec3_make(0, 0, 9), 0);
    vec3 corner = area_grid_point(&grid, 1, 1);
    near(hypot(corner.x, corner.y), 4 * 0.501); /* POV-Ray's thousandth */
    light.orient = light.jitter = true;
    struct area_grid a = area_grid_new(&lamp, vec3_make(1, 2, 9), 7);
    struct area_grid b = area_grid_new(&lamp, vec3_make(1, 2, 9), 7);
    struct area_grid c = area_grid_new(&lamp, vec3_make(1, 2, 9), 8);
    near(vec3_dot(a.axis1, vec3_make(1, 2, 9)), 0);
    near(vec3_dot(a.axis2, vec3_make(1, 2, 9)), 0);
    near(vec3_length(a.axis2), 4);
    vec3 p = area_grid_point(&a, 0, 1), q = area_grid_point(&b, 0, 1);
    assert_memory_equal(&p, &q, sizeof p);
    q = area_grid_point(&c, 0, 1);
    assert_memory_not_equal(&p, &q, sizeof p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fresnel),
        cmocka_unit_test(test_metallic),
        cmocka_unit_test(test_mirror),
        cmocka_unit_test(test_light),
        cmocka_unit_test(test_highlights),
        cmocka_unit_test(test_lit_by),
        cmocka_unit_test(test_fade),
        cmocka_unit_test(test_interiors),
        cmocka_unit_test(test_lamps),
        cmocka_unit_test(test_media_parts),
        cmocka_unit_test(test_parallel),
        cmocka_unit_test(test_area_weights),
        cmocka_unit_test(test_area_adaptive),
        cmocka_unit_test(test_area_outline),
        cmocka_unit_test(test_area_outline_of_disc),
        cmocka_unit_test(test_area_outline_behind_pane),
        cmocka_unit_test(test_area_outline_of_panes),
        cmocka_unit_test(test_area_refined),
        cmocka_unit_test(test_area_shapes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
