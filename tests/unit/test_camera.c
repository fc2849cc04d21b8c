/* scene/camera against rays measured on POV-Ray 3.7. */
#include "harness.h"

#include "base/draw.h"
#include "scene/camera.h"
#include "scene/lens.h"

/* Where the rays through the middles of the first and the last pixel of an
 * 8 x 6 picture meet the plane z = 10. */
static void expect(struct camera camera, double x0, double y0, double x1,
                   double y1)
{
    assert_null(camera_finish(&camera));
    const double at[2][2] = { { 0.5 / 8, 0.5 / 6 }, { 7.5 / 8, 5.5 / 6 } };
    const double wanted[2][2] = { { x0, y0 }, { x1, y1 } };
    for (int i = 0; i < 2; i++) {
        struct ray ray = camera_ray(&camera, at[i][0], at[i][1]);
        assert_true(fabs(vec3_length(ray.direction) - 1) < 1e-12);
        vec3 p = ray_point(&ray, (10 - ray.origin.z) / ray.direction.z);
        assert_true(fabs(p.x - wanted[i][0]) < 2e-3);
        assert_true(fabs(p.y - wanted[i][1]) < 2e-3);
    }
}

static void look_at(struct camera *camera, double x, double y, double z)
{
    camera->look_at = vec3_make(x, y, z);
    camera->has_look_at = true;
}

/* Whatever a ray goes through is seen where the ray starts in the picture. */
static void places_are_where_rays_go(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        struct camera camera = camera_default();
        camera.kind = camera_kind_find(kind ? "orthographic" : "perspective");
        camera.location = vec3_make(3, -1, 2);
        camera.direction = vec3_make(0.2, 0, 1); /* sheared */
        camera.angle = 60;
        look_at(&camera, 1, 2, 5);
        assert_null(camera_finish(&camera));
        for (int i = 0; i < 9; i++) {
            double x = 0.1 + i % 3 * 0.4, y = 0.3 + i / 3 * 0.2, u, v;
            struct ray ray = camera_ray(&camera, x, y);
            vec3 view = camera_view(&camera, ray_point(&ray, 7 + i));
            assert_true(view.z > 0);
            camera_place(&camera, view, &u, &v);
            assert_true(fabs(u - x) < 1e-12 && fabs(v - y) < 1e-12);
        }
        vec3 behind = vec3_along(camera.location, camera.direction, -0.5);
        assert_true(fabs(camera_view(&camera, behind).z + 0.5) < 1e-12);
    }
}

static void perspective_is_povrays(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    expect(camera, -5.819, 4.167, 5.819, -4.167);
    camera.angle = 50;
    look_at(&camera, 1, 2, 5);
    expect(camera, -2.684, 7.172, 6.438, 0.994);
    camera = camera_default();
    camera.sky = vec3_make(1, 1, 0);
    camera.angle = 50;
    look_at(&camera, 0, 0, 5);
    expect(camera, -0.819, 4.951, 0.819, -4.951);
    camera = camera_default();
    camera.direction = vec3_make(0.2, 0, 1);
    camera.right = vec3_make(1, 0, 0);
    camera.angle = 60;
    expect(camera, -3.152, 4.907, 7.152, -4.907);
}

static void mirrored_cameras_stay_mirrored(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    camera.right = vec3_make(-4.0 / 3, 0, 0);
    camera.angle = 40;
    look_at(&camera, 1, 2, 5);
    expect(camera, 6.223, 7.503, -1.074, 1.452);
    camera.sky = camera.up = vec3_make(0, 0, 1);
    expect(camera, -1.94, 3.2, 6.833, 4.981);
}

static void orthographic_sizes_are_povrays(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    camera.kind = camera_kind_find("orthographic");
    look_at(&camera, 0, 0, 5);
    expect(camera, -2.91, 2.084, 2.91, -2.084);
    camera.angle = 60;
    expect(camera, -2.526, 1.809, 2.526, -1.809);
    camera.angle = 0;
    camera.has_size = true;
    camera.right = vec3_make(4, 0, 0);
    camera.up = vec3_make(0, 3, 0);
    expect(camera, -1.75, 1.25, 1.75, -1.25);
    camera = camera_default();
    camera.kind = camera_kind_find("orthographic");
    camera.location = vec3_make(0, 5, -10);
    expect(camera, -7.031, 10.035, 7.031, -0.035);
}

static void transformations_come_last(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    camera.angle = 50;
    look_at(&camera, 1, 0, 5);
    assert_null(camera_finish(&camera));
    affine turn = affine_rotation(vec3_make(0, 0, 10));
    affine shift = affine_translation(vec3_make(1, 0, 0));
    affine both = affine_compose(shift, turn);
    camera_move(&camera, &both);
    camera.has_look_at = false;
    camera.angle = 0;
    expect(camera, -1.373, 2.379, 8.084, -2.045);
}

static void impossible_cameras_are_told(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    look_at(&camera, 0, 0, 0);
    assert_string_equal(camera_finish(&camera),
                        "look_at is the same point as location");
    camera = camera_default();
    camera.angle = 180;
    assert_string_equal(camera_finish(&camera),
                        "its angle must be less than 180 degrees");
    camera.angle = -1;
    assert_string_equal(camera_finish(&camera), "its angle is negative");
    camera = camera_default();
    camera.direction = vec3_make(0, 0, 0);
    assert_string_equal(camera_finish(&camera), "its direction has no length");
}

/* Looking straight into the sky keeps right as it was. */
static void looking_into_the_sky_works(void **state)
{
    (void)state;
    struct camera camera = camera_default();
    look_at(&camera, 0, 5, 0);
    assert_null(camera_finish(&camera));
    struct ray ray = camera_ray(&camera, 0.5, 0.5);
    assert_true(ray.direction.y == 1);
    assert_true(camera.right.x == 1.33 && camera.up.z == -1);
}

/* A packet of rays through a lens is of those that go through it one by one. */
static void packets_are_of_lone_rays(void **state)
{
    (void)state;
    double number[RAY_LANES], x[RAY_LANES], y[RAY_LANES];
    double across[RAY_LANES], above[RAY_LANES];
    struct draw_lanes lanes;
    for (unsigned i = 0; i < RAY_LANES; i++) {
        double begin[2];
        struct draw_slot slot = draw_slot_of(i / 3, 0);
        lens_begin(i / 3, begin);
        number[i] = 7 * i;
        x[i] = begin[0];
        y[i] = begin[1];
        lanes.order[i] = slot.order;
        lanes.first[i] = slot.first;
        lanes.second[i] = slot.second;
        lanes.index[i] = 7 * i;
    }
    lens_disc_points(number, x, y);
    draw_pairs(&lanes, across, above);
    assert_true(lens_is_disc(10) && !lens_is_disc(4) && !lens_is_disc(19));
    for (unsigned i = 0; i < RAY_LANES; i++) {
        const struct draws draws = { i / 3, 7 * i };
        double point[2], drawn[2];
        lens_point(10, (int)(7 * i), i / 3, point);
        draw_pair(&draws, 0, drawn);
        assert_true(point[0] == x[i] && point[1] == y[i]);
        assert_true(drawn[0] == across[i] && drawn[1] == above[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_are_where_rays_go),
        cmocka_unit_test(perspective_is_povrays),
        cmocka_unit_test(mirrored_cameras_stay_mirrored),
        cmocka_unit_test(orthographic_sizes_are_povrays),
        cmocka_unit_test(transformations_come_last),
        cmocka_unit_test(impossible_cameras_are_told),
        cmocka_unit_test(looking_into_the_sky_works),
        cmocka_unit_test(packets_are_of_lone_rays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
