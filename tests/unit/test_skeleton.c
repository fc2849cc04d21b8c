/* skeleton/ as a whole: the rooms of voids.h as a scene, walls and all, and
 * what the heuristics say of them. */
#include <math.h>
#include <stdio.h>

#include "harness.h"
#include "parse/parse.h"
#include "scene_world.h"
#include "skeleton/heuristic.h"
#include "skeleton/void.h"
#include "voids.h"

struct fixture {
    struct arena *arena;
    struct scene *scene;
    struct world *world;
    struct voxels voxels;
    struct skeleton *skeleton;
    struct worker worker;
};

static char *print_box(char *at, const int from[3], const int to[3])
{
    return at + sprintf(at, "box { <%d,%d,%d>/10, <%d,%d,%d>/10 }\n", from[0],
                        from[1], from[2], to[0], to[1], to[2]);
}

/* The boxes one after the other: solid rock, carved, refilled. */
static void print_scene(char *at, const struct void_case *what,
                        const char *albedo, const char *lights)
{
    static const int zero[3] = { 0, 0, 0 };
    char *start = at;
    int boxes = 0;
    while (what->boxes[boxes].to[0] > 0)
        boxes++;
    at += sprintf(at, "#version 3.7; global_settings { assumed_gamma 1 }\n"
                      "background { rgb 0 }\n");
    at += sprintf(at, "%s", lights);
    for (int i = boxes - 1; i >= 0; i--)
        at +=
            sprintf(at, "%s {\n", what->boxes[i].fill ? "difference" : "union");
    at = print_box(at, zero, what->size);
    for (int i = 0; i < boxes; i++) {
        at = print_box(at, what->boxes[i].from, what->boxes[i].to);
        at += sprintf(at, "}\n");
    }
    at -= 2;
    at += sprintf(at, " pigment { rgb %s } finish { ambient 0 diffuse 1 } }\n",
                  albedo);
    assert_true(at - start < 128 * 1024);
}

static struct fixture *fixture_new(const struct void_case *what,
                                   const char *albedo, const char *lights,
                                   const char *heuristic, unsigned threads)
{
    static char text[128 * 1024];
    struct parse_options parse = { .image_width = 3, .image_height = 3 };
    struct arena *arena = arena_new(0);
    struct fixture *f = ARENA_NEW(arena, struct fixture);
    struct diag diag = diag_new();
    struct skeleton_options options = { .heuristic = heuristic_find(heuristic),
                                        .threads = threads };
    f->arena = arena;
    f->voxels = void_case_new(what);
    print_scene(text, what, albedo, lights);
    f->scene = parse_scene(source_from_text(f->arena, "test.pov", text), &parse,
                           f->arena, &diag);
    assert_non_null(f->scene);
    f->world = world_new(f->scene, threads, 0, &diag);
    assert_non_null(f->world);
    f->skeleton = skeleton_new(f->world, f->scene, &f->voxels, &options);
    return f;
}

static void fixture_free(struct fixture *f)
{
    skeleton_free(f->skeleton);
    world_free(f->world);
    scene_free(f->scene);
    void_case_free(&f->voxels);
    arena_free(f->arena);
}

static struct skeleton_light ask(struct fixture *f, double x, double y,
                                 double z, vec3 normal)
{
    return skeleton_light(f->skeleton, &f->worker, vec3_make(x, y, z), normal);
}

static void assert_near(double value, double wanted, double share)
{
    if (!(fabs(value - wanted) <= share * fabs(wanted)))
        fail_msg("%g, not %g", value, wanted);
}

static const vec3 up = { 0, 1, 0 };

/* A lamp that fades as 1/d^2: 2 / (1 + (d/D)^2) -> 2 D^2 / d^2, flux
 * 8 pi D^2 = 8 pi for D = 0.01 and 10^4 white. */
#define LAMP(x)                                                                \
    "light_source { <" x "> rgb <1, 2, 4>*1e4 fade_distance 0.01 fade_power "  \
    "2 }\n"

/* The mean of the indirect light over all walls of a box of 6 x 3.6 x 6, the
 * points in proportion to the area. */
static rgb box_mean(struct fixture *f)
{
    static const vec3 low = { 0.2, 0.2, 0.2 }, size = { 6, 3.6, 6 };
    double lengths[3] = { size.x, size.y, size.z }, total = 0;
    rgb sum = rgb_grey(0);
    for (int side = 0; side < 6; side++) {
        int axis = side / 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
        double area = lengths[a] * lengths[b];
        total += area;
        for (int i = 0; i < 400; i++) {
            double at[3], normal[3] = { 0 };
            normal[axis] = side % 2 ? 1 : -1;
            at[axis] = side % 2 ? 0 : lengths[axis];
            at[a] = lengths[a] * (i % 20 + 0.5) / 20;
            at[b] = lengths[b] * (i / 20 + 0.5) / 20;
            rgb light = ask(f, low.x + at[0], low.y + at[1], low.z + at[2],
                            vec3_make(normal[0], normal[1], normal[2]))
                            .indirect;
            sum = rgb_add_scaled(sum, light, area / 400);
        }
    }
    return rgb_scale(sum, 1 / total);
}

/* All that a lamp gives to the walls of a closed box is swallowed there, so
 * the mean is that of an integrating sphere: rho Phi / (S (1 - rho)). */
static void box_is_an_integrating_sphere(void **state)
{
    (void)state;
    struct fixture *f = fixture_new(&void_box, "<.2, .5, .8>",
                                    LAMP("3.2, 3.0, 3.2"), "network", 2);
    double flux = 8 * 3.14159265358979323846;
    double area = 2 * (6 * 6 + 2 * 6 * 3.6);
    rgb mean = box_mean(f);
    assert_near(mean.r, flux * 0.2 / (area * 0.8), 0.02);
    assert_near(mean.g, 2 * flux * 0.5 / (area * 0.5), 0.02);
    assert_near(mean.b, 4 * flux * 0.8 / (area * 0.2), 0.02);
    fixture_free(f);
}

/* Light falls off from room to room, and gets everywhere; each heuristic says
 * so, and where from. */
static void rooms_get_darker(void **state)
{
    (void)state;
    for (size_t i = 0; heuristic_at(i); i++) {
        struct fixture *f = fixture_new(
            &void_rooms, ".5", LAMP("2.0, 2.6, 2.0"), heuristic_at(i)->name, 1);
        struct skeleton_light first = ask(f, 1, 0.2, 1, up);
        struct skeleton_light corridor = ask(f, 5, 0.2, 8, up);
        struct skeleton_light second = ask(f, 11, 0.2, 8, up);
        print_message("%s: %g %g %g\n", heuristic_at(i)->name, first.arriving.g,
                      corridor.arriving.g, second.arriving.g);
        assert_true(first.arriving.g > 3 * corridor.arriving.g);
        assert_true(corridor.arriving.g > 1.2 * second.arriving.g);
        assert_true(second.arriving.g > 1e-6);
        assert_true(second.indirect.g > 0);
        assert_true(second.stream.x < 0);
        vec3 lamp = vec3_normalise(vec3_make(1, 2.4, 1));
        if (heuristic_at(i)->indirect == NULL)
            assert_true(vec3_dot(vec3_normalise(first.stream), lamp) > 0.99);
        fixture_free(f);
    }
}

/* Many lamps, some chosen by chance, give what all give. */
static void many_lamps_are_drawn(void **state)
{
    static char lights[8192];
    double light[2];
    (void)state;
    for (int i = 0; i < 2; i++) {
        char *at = lights;
        for (int k = 0; k < 60; k++)
            at += sprintf(at,
                          "light_source { <%g, 3, %g> rgb %g fade_distance 1 "
                          "fade_power 2 }\n",
                          0.5 + 0.09 * k, 0.5 + 0.08 * (k * 7 % 60),
                          i == 0   ? 1.0
                          : k == 0 ? 60.0
                                   : 0.0);
        struct fixture *f =
            fixture_new(&void_box, ".5", i ? "" : lights, "network", 2);
        light[i] = ask(f, 3, 0.2, 3, up).indirect.g;
        fixture_free(f);
    }
    assert_true(light[0] > 0);
    assert_true(light[1] == 0);
}

/* The same bits from one thread and from three. */
static void threads_change_nothing(void **state)
{
    struct skeleton_light light[2];
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        struct fixture *f =
            fixture_new(&void_nine, "<.2, .5, .8>", LAMP("1.9, 2.2, 1.9"),
                        "network", 1 + 2 * i);
        light[i] = ask(f, 8, 0.2, 8, up);
        fixture_free(f);
    }
    assert_memory_equal(&light[0], &light[1], sizeof light[0]);
}

/* Of 600 lamps some are asked, at some of the walls; where all stand together
 * the estimate is close. */
static void lamps_in_one_place_are_one(void **state)
{
    static char many[64 * 1024];
    char *at = many;
    (void)state;
    for (int k = 0; k < 600; k++)
        at += sprintf(at, "light_source { <2,2.6,2> rgb 1 fade_distance 1 "
                          "fade_power 2 }\n");
    static const char one[] = "light_source { <2,2.6,2> rgb 600 fade_distance "
                              "1 fade_power 2 }\n";
    static const char *const names[] = { "network", "forward" };
    for (int i = 0; i < 2; i++) {
        struct fixture *f = fixture_new(&void_rooms, ".5", many, names[i], 2);
        struct fixture *g = fixture_new(&void_rooms, ".5", one, names[i], 2);
        for (double z = 1; z < 9; z += 3) {
            struct skeleton_light light = ask(f, 5, 0.2, z, up);
            struct skeleton_light same = ask(g, 5, 0.2, z, up);
            assert_near(light.stream.x, same.stream.x, 0.15);
            assert_near(light.arriving.g, same.arriving.g, 0.15);
        }
        fixture_free(f);
        fixture_free(g);
    }
}

/* Somebody who doesn't want it any more gets none. */
static void a_stop_is_heard(void **state)
{
    (void)state;
    struct fixture *f =
        fixture_new(&void_box, ".5", LAMP("3, 3, 3"), "forward", 1);
    atomic_int stop = 1;
    struct skeleton_options options = { .threads = 2, .stop = &stop };
    assert_null(skeleton_new(f->world, f->scene, &f->voxels, &options));
    fixture_free(f);
}

/* Points that no void is near are dark, not an error. */
static void far_away_is_dark(void **state)
{
    (void)state;
    struct fixture *f =
        fixture_new(&void_box, ".5", LAMP("3, 3, 3"), "network", 1);
    assert_true(ask(f, 1e9, -1e9, 0, up).indirect.g == 0);
    assert_true(ask(f, -0.2, -0.2, -0.2, up).indirect.g == 0);
    fixture_free(f);
}

/* Outside of the grid there is the sky. */
static void the_sky_is_outside(void **state)
{
    (void)state;
    struct fixture *f =
        fixture_new(&void_box, ".5",
                    "background { rgb <.3, .4, .6> }"
                    " global_settings { light_mesh { sky on } }",
                    "network", 1);
    rgb outside = ask(f, -3, -3, 2, up).indirect;
    assert_near(outside.r, 0.3, 1e-6);
    assert_near(outside.b, 0.6, 1e-6);
    assert_true(ask(f, 3, 0.2, 3, up).indirect.g == 0);
    fixture_free(f);
}

/* A scene that is told as text, and the skeleton of its void. */
struct told {
    struct scene_world *all;
    struct void_space *space;
    struct skeleton *skeleton;
};

static struct told told_new(const char *text, int resolution)
{
    struct told told = { .all = scene_world_new(text) };
    const struct grid_wish wish = { .resolution = resolution };
    const struct skeleton_options options = { .threads = 2 };
    told.space = void_new(told.all->scene, told.all->world, wish, 2, NULL,
                          &told.all->diag);
    assert_non_null(told.space);
    told.skeleton = skeleton_new(told.all->world, told.all->scene,
                                 &told.space->voxels, &options);
    return told;
}

static void told_free(struct told *told)
{
    skeleton_free(told->skeleton);
    void_free(told->space);
    scene_world_free(told->all);
}

/* A room with a lamp, and one without that the camera is in. A voxel is 0.28,
 * the wall between them 0.1: thinner than one, and anywhere in it. */
static const char two_rooms[] =
    "difference {\n"
    "  box { <-4.1,-1.6,-2.1>, <4.1,1.6,2.1> }\n"
    "  box { <-4,-1.5,-2>, <0.1,1.5,2> } box { <0.2,-1.5,-2>, <4,1.5,2> }\n"
    "  pigment { rgb 1 } finish { ambient 0 diffuse 0.7 }\n"
    "}\n"
    "light_source { <-2,0.5,0>, 1 }\n"
    "camera { location <2,0,0.5> look_at 0 }\n";

/* Close to the wall void is closest on its other side: no light comes from
 * there, wherever one asks, and on this side there is. */
static void light_stays_on_its_side(void **state)
{
    (void)state;
    struct told rooms = told_new(two_rooms, 32);
    struct skeleton *skeleton = rooms.skeleton;
    struct worker worker = { 0 };
    const vec3 dark = { 2, 0, 0 }, bright = { -2, 0, 0 };
    for (int i = 0; i < 40; i++) {
        double off = 0.01 + 0.4 * (i % 8) / 8, z = -1.9 + 0.75 * (i / 8);
        vec3 there = vec3_make(0.2 + off, -1.5, z);
        vec3 here = vec3_make(0.1 - off, -1.5, z);
        assert_true(rgb_peak(skeleton_indirect(skeleton, &worker, there, up)) ==
                    0);
        rgb close;
        assert_true(skeleton_close(skeleton, &worker, there, up, dark, &close));
        assert_true(rgb_peak(close) == 0);
        double whole = rgb_peak(skeleton_indirect(skeleton, &worker, here, up));
        assert_true(whole > 0);
        assert_true(
            skeleton_close(skeleton, &worker, here, up, bright, &close));
        assert_near(rgb_peak(close), whole, 0.25);
    }
    told_free(&rooms);
}

/* A lamp above a table lights its top, and the floor before it. */
static const char table[] =
    "#default { finish { ambient 0 diffuse 0.75 } }\n"
    "box { <-3,0,-4>, <3,2.7,1.4> inverse pigment { rgb 0.6 } }\n"
    "box { <-1.4,0.7,-0.3>, <1.4,0.75,0.9> pigment { rgb 0.6 } }\n"
    "light_source { <-0.7,1.45,0.3>, 12 spotlight point_at <-0.4,0.75,0.2>\n"
    "  radius 35 falloff 50 fade_distance 0.8 fade_power 2 }\n"
    "camera { location <0,1,-3.5> look_at <0,0.7,0.4> }\n";

/* The room is one chamber, and the floor below the table is darker than that
 * before it: paths say by how much. */
static void below_a_table_it_is_dim(void **state)
{
    (void)state;
    struct told room = told_new(table, 48);
    struct skeleton *skeleton = room.skeleton;
    struct worker worker = { 0 };
    const vec3 below = { 0, 0, 0.3 }, before = { 0, 0, -1.5 };
    double dim = rgb_peak(skeleton_indirect(skeleton, &worker, below, up)),
           lit = rgb_peak(skeleton_indirect(skeleton, &worker, before, up));
    assert_near(dim / lit, 0.47, 0.2);
    told_free(&room);
}

/* A room that only strips of light behind a cornice light, in a gap less wide
 * than two voxels: what comes out of there has met the walls of the gap first.
 */
static const char cove[] =
    "#default { pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }\n"
    "box { <-2.5,0,-3>, <2.5,2.8,3> inverse }\n"
    "#for (S, -1, 1, 2)\n"
    "  box { <2.28,2.45,-3>, <2.32,2.62,3> scale <S,1,1> }\n"
    "  box { <2.32,2.45,-3>, <2.5,2.48,3> scale <S,1,1> }\n"
    "  box { <2.36,2.49,-3>, <2.42,2.51,3> scale <S,1,1>\n"
    "    finish { emission 6 } }\n"
    "#end\n"
    "camera { location <0,1.5,-2.8> look_at <0,1.4,0> }\n";

/* Paths say how much there is on the floor (0.125). */
static void a_cove_lights_its_room(void **state)
{
    (void)state;
    struct told room = told_new(cove, 48);
    struct worker worker = { 0 };
    const vec3 floor = { 0, 0, -1 };
    assert_near(rgb_peak(skeleton_indirect(room.skeleton, &worker, floor, up)),
                0.125, 0.2);
    told_free(&room);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_is_an_integrating_sphere),
        cmocka_unit_test(rooms_get_darker),
        cmocka_unit_test(many_lamps_are_drawn),
        cmocka_unit_test(lamps_in_one_place_are_one),
        cmocka_unit_test(a_stop_is_heard),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(far_away_is_dark),
        cmocka_unit_test(the_sky_is_outside),
        cmocka_unit_test(light_stays_on_its_side),
        cmocka_unit_test(below_a_table_it_is_dim),
        cmocka_unit_test(a_cove_lights_its_room),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
