/* Tests of surface_grid.h: corners that stay on a surface while the camera
 * moves. */
#include "harness.h"

#include <math.h>

#include "lightmesh/surface_grid.h"
#include "scene/camera.h"

static const int size[2] = { 320, 240 };

/* On a slope, y = 0.3 x + 0.1 z. */
static struct receiver on_slope(double x, double z, vec3 from)
{
    return (struct receiver){
        .point = vec3_make(x, 0.3 * x + 0.1 * z, z),
        .side = vec3_normalise(vec3_make(-0.3, 1, -0.1)),
        .from = from,
    };
}

static struct surface_grid grid_at(vec3 eye)
{
    struct camera camera = camera_default();
    camera.location = eye;
    return surface_grid_new(&camera, size, 4, vec3_make(0.1, 0.2, 0.3), 0.5);
}

/* Lines meet the slope within their cells, and between its corners the place
 * itself is interpolated. */
static void corners_are_around(void **state)
{
    struct surface_grid grid = grid_at(vec3_make(0, 3, -4));
    (void)state;
    for (int i = 0; i < 50; i++) {
        struct receiver receiver =
            on_slope(0.37 * i - 9, 0.21 * i, vec3_make(0, 3, -4));
        struct grid_cell cell;
        double sum = 0, blend, weight[GRID_CORNERS];
        vec3 mean = { 0, 0, 0 };
        int level = surface_grid_level(&grid, &receiver, &blend);
        assert_true(surface_grid_cell(&grid, &receiver, level, &cell, weight));
        assert_true(blend >= 0 && blend < 1);
        for (int corner = 0; corner < GRID_CORNERS; corner++) {
            double length;
            struct ray line = grid_corner_line(&grid, &cell, corner, &length);
            double above =
                vec3_dot(vec3_sub(line.origin, receiver.point), receiver.side);
            double t = above / -vec3_dot(line.direction, receiver.side);
            assert_true(t > 0 && t < length);
            vec3 met = vec3_along(line.origin, line.direction, t);
            mean = vec3_along(mean, met, weight[corner]);
            sum += weight[corner];
        }
        assert_true(fabs(sum - 1) < 1e-9);
        assert_true(vec3_length(vec3_sub(mean, receiver.point)) < 1e-9);
    }
}

/* A camera that comes nearer changes the level by and by, and no corner of a
 * level. */
static void corners_stay(void **state)
{
    double before = HUGE_VAL, steps = 0;
    struct grid_cell first;
    (void)state;
    for (int i = 0; i < 200; i++) {
        vec3 eye = vec3_make(0, 9 - 0.04 * i, -9 + 0.04 * i);
        struct surface_grid grid = grid_at(eye);
        struct receiver receiver = on_slope(0.4, 0.7, eye);
        struct grid_cell cell;
        double blend, weight[GRID_CORNERS];
        int level = surface_grid_level(&grid, &receiver, &blend);
        double exact = level + blend;
        assert_true(exact <= before && (i == 0 || before - exact < 0.25));
        steps += i > 0 && exact < before;
        before = exact;
        assert_true(surface_grid_cell(&grid, &receiver, 9, &cell, weight));
        if (i == 0)
            first = cell;
        assert_true(grid_cells_same(&cell, &first));
    }
    assert_true(steps > 20);
}

/* All corners around have names of their own, on the other side too. */
static void names_differ(void **state)
{
    struct surface_grid grid = grid_at(vec3_make(0, 3, -4));
    struct receiver receiver = on_slope(1, 2, vec3_make(0, 3, -4));
    uint64_t keys[3 * GRID_CORNERS];
    double weight[GRID_CORNERS];
    struct grid_cell cell;
    int count = 0;
    (void)state;
    for (int i = 0; i < 3; i++) {
        if (i == 1)
            receiver.side = vec3_negate(receiver.side);
        assert_true(surface_grid_cell(&grid, &receiver, i < 2 ? 10 : 11, &cell,
                                      weight));
        for (int corner = 0; corner < GRID_CORNERS; corner++)
            keys[count++] = grid_corner_key(&cell, corner, 0, 0);
    }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++)
            assert_true(keys[i] != keys[j]);
    assert_true(keys[0] != grid_corner_key(&cell, 0, 3, 0) && keys[0] != 0);
    for (int way = 1; way <= 8; way++)
        for (int kind = 0; kind < 4; kind++)
            assert_true(grid_corner_key(&cell, 0, kind, way) !=
                        grid_corner_key(&cell, 0, kind, way - 1));
}

/* A place is in a cell if that is found for it, and counts the same there. */
static void places_are_within_their_cell(void **state)
{
    struct surface_grid grid = grid_at(vec3_make(0, 3, -4));
    struct receiver receiver = on_slope(1, 2, vec3_make(0, 3, -4));
    struct grid_cell cell, found;
    double weight[GRID_CORNERS], again[GRID_CORNERS];
    int within = 0;
    (void)state;
    assert_true(surface_grid_cell(&grid, &receiver, 10, &cell, weight));
    for (int i = 0; i < 400; i++) {
        struct receiver other = on_slope(
            1 + 0.1 * (i % 20 - 10) * grid.step[10],
            2 + 0.1 * (i / 20 - 10) * grid.step[10], vec3_make(0, 3, -4));
        assert_true(surface_grid_cell(&grid, &other, 10, &found, weight));
        bool same = grid_cells_same(&cell, &found);
        assert_true(surface_grid_within(&grid, &cell, other.point, again) ==
                    same);
        for (int k = 0; same && k < GRID_CORNERS; k++)
            assert_true(fabs(again[k] - weight[k]) < 1e-12);
        within += same;
    }
    assert_true(within > 20 && within < 380);
}

/* From corner to corner it is a step along one of the two axes, and as much
 * along the third as keeps it on the surface. */
static void cells_go_along_their_surface(void **state)
{
    struct surface_grid grid = grid_at(vec3_make(0, 3, -4));
    struct receiver receiver = on_slope(1, 2, vec3_make(0, 3, -4));
    double weight[GRID_CORNERS];
    struct grid_cell cell;
    (void)state;
    assert_true(surface_grid_cell(&grid, &receiver, 10, &cell, weight));
    for (int axis = 0; axis < 2; axis++) {
        vec3 along = grid_cell_along(&cell, receiver.side, axis, 0.5);
        const double parts[3] = { along.x, along.y, along.z };
        assert_true(fabs(vec3_dot(along, receiver.side)) < 1e-12);
        assert_true(parts[(cell.axis + 1 + axis) % 3] == 0.5);
        assert_true(parts[(cell.axis + 2 - axis) % 3] == 0);
    }
}

/* So far away there are no names. */
static void far_is_refused(void **state)
{
    struct surface_grid grid = grid_at(vec3_make(0, 3, -4));
    struct receiver receiver = on_slope(1e9, 2, vec3_make(0, 3, -4));
    struct grid_cell cell;
    double weight[GRID_CORNERS];
    (void)state;
    assert_false(surface_grid_cell(&grid, &receiver, 4, &cell, weight));
    receiver.point.x = (double)NAN;
    assert_false(surface_grid_cell(&grid, &receiver, 4, &cell, weight));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_are_around),
        cmocka_unit_test(corners_stay),
        cmocka_unit_test(names_differ),
        cmocka_unit_test(places_are_within_their_cell),
        cmocka_unit_test(cells_go_along_their_surface),
        cmocka_unit_test(far_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
