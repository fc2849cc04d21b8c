/* scene/height_grid: what rays, boxes and points are told of a grid is what all
 * its triangles say one by one. */
#include "harness.h"

#include <math.h>

#include "scene/height_grid.h"
#include "scene/mesh.h"
#include "shapes.h"

enum { WIDTH = 23, HEIGHT = 38, FOUND_MAX = 256 };

struct ground {
    struct arena *arena;
    struct height_grid grid;
    struct mesh mesh; /* the same */
};

/* Hills and holes; `step` makes them flat in places. */
static struct ground ground_new(double water, int step)
{
    struct ground ground = { .arena = arena_new(0) };
    struct height_grid *grid = &ground.grid;
    struct mesh *mesh = &ground.mesh;
    struct dice dice = { 7 };
    *grid = (struct height_grid){ .width = WIDTH,
                                  .height = HEIGHT,
                                  .water = water };
    grid->heights = ARENA_ARRAY(ground.arena, uint16_t, WIDTH * HEIGHT);
    mesh->vertices = ARENA_ARRAY(ground.arena, vec3, WIDTH * HEIGHT);
    mesh->triangles =
        ARENA_ARRAY(ground.arena, struct mesh_triangle, 2 * WIDTH * HEIGHT);
    for (int k = 0; k < WIDTH * HEIGHT; k++) {
        int h = (int)dice_between(&dice, 0, 20) / step * step;
        grid->heights[k] = (uint16_t)h;
        mesh->vertices[k] = vec3_make(k % WIDTH, h, k / WIDTH);
    }
    for (uint32_t j = 0; j < HEIGHT - 1; j++)
        for (uint32_t i = 0; i < WIDTH - 1; i++) {
            uint32_t a = j * WIDTH + i, d = a + WIDTH + 1;
            mesh->triangles[mesh->triangle_count++] =
                (struct mesh_triangle){ .vertex = { a, a + WIDTH, d } };
            mesh->triangles[mesh->triangle_count++] =
                (struct mesh_triangle){ .vertex = { a, d, a + 1 } };
        }
    height_grid_prepare(grid, ground.arena);
    return ground;
}

struct found {
    int count;
    struct hit at[FOUND_MAX];
};

static bool found_add(void *context, const struct hit *hit)
{
    struct found *found = context;
    assert_true(found->count < FOUND_MAX);
    assert_true(found->count == 0 || found->at[found->count - 1].t <= hit->t);
    found->at[found->count++] = *hit;
    return false;
}

static void ray_agrees(const struct ground *ground, const struct ray *ray,
                       double tmin, double tmax, int *met)
{
    struct found found = { .count = 0 };
    bool taken[FOUND_MAX] = { false };
    int count = 0;
    struct hit hit;
    height_grid_crossings(&ground->grid, ray, tmin, tmax, found_add, &found);
    for (size_t i = 0; i < ground->mesh.triangle_count; i++) {
        if (!mesh_intersect(&ground->mesh, i, ray, &hit) || hit.t <= tmin ||
            hit.t >= tmax || ray_point(ray, hit.t).y < ground->grid.water)
            continue;
        count++;
        for (int k = 0; k < found.count; k++)
            if (found.at[k].part == (int)i && !taken[k]) {
                taken[k] = true;
                assert_true(fabs(found.at[k].t - hit.t) < 1e-9);
                break;
            }
    }
    assert_int_equal(count, found.count);
    for (int k = 0; k < found.count; k++)
        assert_true(taken[k]);
    *met += count;
}

static void rays_meet_each_triangle(void **state)
{
    static const double waters[] = { 0, 7.5, 15 };
    int met = 0;
    (void)state;
    for (int w = 0; w < 3; w++) {
        struct ground ground = ground_new(waters[w], 1);
        struct dice dice = { 3 };
        for (int i = 0; i < 3000; i++) {
            vec3 at = { dice_between(&dice, 0, WIDTH - 1),
                        dice_between(&dice, 0, 20),
                        dice_between(&dice, 0, HEIGHT - 1) };
            vec3 way = vec3_scale(dice_point(&dice, 1), 10);
            struct ray ray = { at, way };
            if (i % 4 == 1)
                ray.direction.y *= 0.05;
            if (i % 8 == 2)
                ray.direction.x = 0;
            if (i % 8 == 6)
                ray.direction = vec3_make(0, i % 16 < 8 ? 1 : -1, 0);
            ray_agrees(&ground, &ray, i % 3 ? -HUGE_VAL : 0,
                       i % 5 ? HUGE_VAL : 0.7, &met);
        }
        arena_free(ground.arena);
    }
    assert_true(met > 5000);
}

/* Along rows, columns and diagonals, through points of the grid: what is
 * entered is left, and never is nothing met between a point above the ground
 * and one below it. */
static void rays_along_lines_leak_nowhere(void **state)
{
    struct ground ground = ground_new(0, 5);
    struct dice dice = { 11 };
    (void)state;
    for (int i = 0; i < 4000; i++) {
        vec3 from = { trunc(dice_between(&dice, 0, WIDTH)),
                      25 - trunc(dice_between(&dice, 0, 6)),
                      trunc(dice_between(&dice, 0, HEIGHT)) };
        vec3 to = { trunc(dice_between(&dice, 0, WIDTH)),
                    -1 - trunc(dice_between(&dice, 0, 6)),
                    trunc(dice_between(&dice, 0, HEIGHT)) };
        if (i % 3 == 0)
            to.x = from.x;
        if (i % 3 == 1)
            to.z = from.z;
        struct ray ray = { from, vec3_sub(to, from) };
        struct found found = { .count = 0 };
        height_grid_crossings(&ground.grid, &ray, -10, 10, found_add, &found);
        assert_int_equal(found.count % 2, 1);
    }
    arena_free(ground.arena);
}

struct search {
    struct box3 box;
    bool seen[WIDTH * HEIGHT];
};

static bool search_add(void *context, int i, int j)
{
    struct search *search = context;
    search->seen[j * WIDTH + i] = true;
    return false;
}

static void boxes_find_their_squares(void **state)
{
    struct ground ground = ground_new(0, 1);
    struct dice dice = { 19 };
    (void)state;
    for (int n = 0; n < 500; n++) {
        struct search search = { .box = box3_empty() };
        for (int k = 0; k < 2; k++)
            search.box = box3_add(search.box,
                                  vec3_make(dice_between(&dice, -2, WIDTH),
                                            dice_between(&dice, -2, 22),
                                            dice_between(&dice, -2, HEIGHT)));
        height_grid_search(&ground.grid, search.box, search_add, &search);
        for (size_t i = 0; i < ground.mesh.triangle_count; i++) {
            struct box3 box = box3_empty();
            const uint32_t *v = ground.mesh.triangles[i].vertex;
            for (int k = 0; k < 3; k++)
                box = box3_add(box, ground.mesh.vertices[v[k]]);
            if (!box3_is_empty(box3_intersection(box, search.box)))
                assert_true(search.seen[v[0]]);
        }
    }
    arena_free(ground.arena);
}

static void heights_are_those_of_the_planes(void **state)
{
    struct ground ground = ground_new(6, 1);
    double h;
    (void)state;
    for (int j = 0; j < HEIGHT; j++)
        for (int i = 0; i < WIDTH; i++) {
            double want = ground.grid.heights[j * WIDTH + i];
            bool dry = height_grid_over(&ground.grid, i, j, &h);
            assert_true(dry == (want >= 6));
            assert_true(h == want);
        }
    assert_false(height_grid_over(&ground.grid, -0.1, 3, &h));
    assert_false(height_grid_over(&ground.grid, 3, HEIGHT - 0.9, &h));
    arena_free(ground.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_meet_each_triangle),
        cmocka_unit_test(rays_along_lines_leak_nowhere),
        cmocka_unit_test(boxes_find_their_squares),
        cmocka_unit_test(heights_are_those_of_the_planes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
