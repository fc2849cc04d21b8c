/* What indirect light is worth in a picture, and what it may cost; one lamp
 * drawn of many. */
#include "harness.h"

#include "lightmesh/drawn_lamp.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/outlook.h"
#include "lightmesh/plan.h"
#include "lightmesh/plan_rays.h"
#include "lightmesh/tuning.h"
#include "scene_world.h"

#define CAMERA "camera { location <0, 3, -10> look_at <0, 1, 0> } "
#define LAMP   "light_source { <0, 6, -8>, 1 } "

static struct survey surveyed(const char *text)
{
    struct scene_world *all = scene_world_new(text);
    struct lamps lamps = lamps_new(all->world, all->scene, 9, 0);
    struct emitters *emitters = emitters_new(all->world, true);
    struct ambience ambience = ambience_new(all->world, all->scene);
    const struct gather gather = { .lamps = &lamps,
                                   .emitters = emitters,
                                   .ambience = &ambience };
    struct worker worker = { .scratch = arena_new(0) };
    const struct survey_options look = { .rays = SURVEY_RAYS };
    struct survey survey = survey_of(&gather, all->scene, &worker, &look);
    arena_free(worker.scratch);
    emitters_free(emitters);
    lamps_free(&lamps);
    scene_world_free(all);
    return survey;
}

static void test_open(void **state)
{
    struct survey plane = surveyed(
        CAMERA LAMP "plane { y, 0 pigment { rgb 1 } finish { ambient 0.2 } }");
    struct survey nothing = surveyed(CAMERA LAMP);
    (void)state;
    assert_true(plane.open == 1 && plane.worth == 0 && plane.rough == 0);
    assert_true(nothing.open == 1 && nothing.worth == 0);
    assert_true(rgb_peak(plane.around.light) == 0);
    assert_true(plane.around.open == 1);
}

static void test_room(void **state)
{
    struct survey room = surveyed(
        CAMERA LAMP "box { <-6, 0, -11>, <6, 7, 6> inverse pigment { rgb 1 } "
                    "finish { ambient 0.2 diffuse 0.7 } }");
    struct survey yard =
        surveyed(CAMERA LAMP "plane { y, 0 pigment { rgb 1 } } box { -2, 2 }");
    (void)state;
    assert_true(room.open == 0 && room.worth > 0.1 && room.rough > 0.05);
    assert_true(room.around.light.r > 0.05 && room.around.open == 0);
    assert_true(yard.open > 0.5 && yard.open < 1 && yard.worth > 0 &&
                yard.worth < room.worth);
}

/* What is seen only in a mirror counts, and what is behind many panes; and what
 * lets most light pass, if nothing is behind it. */
static void test_beyond(void **state)
{
    static const char hall[] =
        "light_source { <0, 6, -8>, 1 } box { <-6, 0, -30>, <6, 7, 6> inverse "
        "pigment { rgb 1 } finish { ambient 0 diffuse 0.7 } } ";
    static const char *const before[] = {
        "camera { location <0, 3, -10> look_at <0, 3, 0> } "
        "box { <-6, 0, 4>, <6, 7, 5> "
        "finish { ambient 0 diffuse 0 reflection 0.8 } }",
        "camera { location <0, 3, -10> look_at <0, 3, 0> } "
        "box { <-6, 0, -9>, <6, 7, -8.9> pigment { rgbt 0.98 } } "
        "box { <-6, 0, -8>, <6, 7, -7.9> pigment { rgbt 0.98 } } "
        "box { <-6, 0, -7>, <6, 7, -6.9> pigment { rgbt 0.98 } }",
    };
    char text[1000];
    (void)state;
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text, "%s%s", hall, before[i]);
        struct survey survey = surveyed(text);
        assert_true(survey.open == 0 && survey.worth > 0.1);
    }
    struct survey tube = surveyed(
        CAMERA LAMP "cylinder { 0, 3*y, 2 open pigment { rgb 1 filter 0.6 } }");
    assert_true(tube.sights > 0 && tube.worth > 0.02);
}

static struct outlook outlooked(const char *text)
{
    struct scene_world *all = scene_world_new(text);
    struct outlook outlook = outlook_of(all->world, all->scene, 320);
    scene_world_free(all);
    return outlook;
}

/* What the camera stands in or looks through says nothing of the scene's size,
 * nor does a sky that takes no light. */
static void test_outlook(void **state)
{
    static const char plane[] = CAMERA "plane { y, 0 } ";
    const char *const beside[] = {
        CAMERA "plane { y, 0 } sphere { <0, 3, -10>, 0.001 hollow "
               "pigment { rgb 0.5 transmit 100 } finish { diffuse 0 } }",
        CAMERA "plane { y, 0 } sphere { <0, 3, -10>, 0.01 hollow "
               "pigment { rgbt 1 } } sphere { <0, 3, -10>, 0.02 hollow "
               "pigment { rgbf 1 } }",
        CAMERA "plane { y, 0 } sphere { 0, 1e6 hollow pigment { rgb 1 } "
               "finish { ambient 1 diffuse 0 } }",
    };
    const struct outlook wanted = outlooked(plane);
    (void)state;
    assert_true(wanted.distance > 5);
    for (int i = 0; i < 3; i++) {
        const struct outlook outlook = outlooked(beside[i]);
        assert_true(fabs(outlook.distance / wanted.distance - 1) < 1e-9);
        assert_true(fabs(outlook.pixel / wanted.pixel - 1) < 1e-9);
    }
}

/* Rays are saved before points are. */
static void test_afford(void **state)
{
    struct scene_world *all = scene_world_new(CAMERA);
    const struct survey survey = { .open = 0.5, .worth = 0.1, .bounced = 0.1 };
    struct mesh_frame few = { .spacing = 1, .gather = 1, .samples = 128 };
    struct mesh_frame many = few, crowd = few;
    (void)state;
    assert_false(plan_afford(&few, all->scene, &survey, 100, 100000, false));
    assert_true(few.samples == 128 && few.gather == 1);
    assert_true(plan_afford(&many, all->scene, &survey, 200, 100000, false));
    assert_true(many.samples < 128 && many.samples >= 32 && many.gather == 1);
    assert_true(plan_afford(&crowd, all->scene, &survey, 50000, 100000, false));
    assert_true(crowd.samples == 16 && crowd.gather > 1);
    /* As long as points can be fewer, none has less than 32. */
    for (int points = 200; points < 50000; points += 7) {
        struct mesh_frame frame = few;
        plan_afford(&frame, all->scene, &survey, points, 100000, false);
        assert_true(frame.samples >= 32 || frame.gather == 3);
    }
    scene_world_free(all);
}

/* Where rays are dear there are fewer points, unless what they bring is most of
 * the picture and rough; in a film points have more rays. */
static void test_afford_dear(void **state)
{
    struct scene_world *all = scene_world_new(CAMERA);
    struct survey cheap = { .open = 0.5, .worth = 0.3, .bounced = 0.3 };
    const struct mesh_frame whole = { .spacing = 1,
                                      .gather = 1,
                                      .samples = 64 };
    struct mesh_frame usual = whole, fewer = whole, film = whole;
    struct mesh_frame most = { .spacing = 1, .gather = 1, .samples = 32 },
                      same = most, even = most;
    (void)state;
    cheap.rough = 0.33;
    cheap.sent = 1;
    struct survey dear = cheap, much = cheap;
    dear.sent = 4;
    much.worth = much.bounced = 0.6;
    much.rough = 0.7;
    assert_true(plan_afford(&usual, all->scene, &cheap, 3000, 100000, false));
    assert_true(plan_afford(&fewer, all->scene, &dear, 3000, 100000, false));
    assert_true(plan_afford(&most, all->scene, &much, 20000, 100000, false));
    much.sent = 4;
    assert_true(plan_afford(&same, all->scene, &much, 20000, 100000, false));
    much.rough = 0.35;
    assert_true(plan_afford(&even, all->scene, &much, 20000, 100000, false));
    assert_true(plan_afford(&film, all->scene, &cheap, 3000, 100000, true));
    assert_true(usual.samples == 32 && fewer.samples == 32);
    assert_true(fewer.gather > 1.2 * usual.gather);
    assert_true(same.samples == most.samples && same.gather == most.gather);
    assert_true(most.gather > 1 && even.gather > 1.5 * most.gather);
    assert_true(film.samples == 64);
    scene_world_free(all);
}

/* Where surfaces give little light fewer short rays are sent, but for a film.
 */
static void test_near_rays(void **state)
{
    const struct light_mesh_settings said = { 0 }, fine = { .quality = 8 };
    const struct survey little = { .worth = 0.1 }, much = { .worth = 0.3 };
    int few = plan_lone_rays(&said, &little, false),
        usual = plan_lone_rays(&said, &much, false);
    (void)state;
    assert_true(few > 0 && few < usual);
    assert_int_equal(plan_lone_rays(&said, &little, true), usual);
    assert_true(plan_lone_rays(&fine, &little, false) > usual);
}

/* One of these in four is in a crevice. */
static struct survey creviced(double worth)
{
    struct survey survey = { .worth = worth, .sights = 4 };
    for (int i = 0; i < 4; i++)
        survey.sight[i].half = i == 0 ? 0.1 : HUGE_VAL;
    return survey;
}

/* Of those in a crevice likewise. */
static void test_own_rays(void **state)
{
    const struct light_mesh_settings said = { 0 };
    const struct lattice lattice = { .spacing = 1 };
    const struct lattice_view view = { .coarser = 0 };
    const struct survey little = creviced(0.06), much = creviced(0.3);
    const struct plan_own few = plan_own_rays(&said, &little, &lattice, &view,
                                              false),
                          usual = plan_own_rays(&said, &much, &lattice, &view,
                                                false),
                          film = plan_own_rays(&said, &little, &lattice, &view,
                                               true);
    (void)state;
    assert_true(usual.rays > 4 && usual.worth > 0);
    assert_true(few.rays < usual.rays);
    assert_true(film.rays == usual.rays && film.worth == usual.worth);
}

/* Ways are drawn in nets: their numbers are powers of two. */
static void test_nets(void **state)
{
    struct scene_world *all = scene_world_new(CAMERA);
    struct survey survey = { .open = 0.5, .worth = 0.1, .bounced = 0.1 };
    const struct outlook outlook = { .pixel = 0.01, .size = 10, .across = 10 };
    (void)state;
    for (int i = 1; i < 40; i++) {
        survey.rough = i * 0.02;
        struct mesh_frame frame =
            plan_frame(all->scene, &outlook, &survey, PLAN_ALONE, 0);
        assert_true((frame.samples & (frame.samples - 1)) == 0);
        plan_afford(&frame, all->scene, &survey, 100.0 * i, 100000, false);
        assert_true(frame.samples >= 16);
        assert_true((frame.samples & (frame.samples - 1)) == 0);
    }
    scene_world_free(all);
}

/* What meets a checkered floor sees about as much of both colours, however near
 * to one's middle; one colour stays. */
static void test_paint(void **state)
{
    struct scene_world *all =
        scene_world_new("plane { y, 0 pigment { checker rgb 0, rgb 1 } } "
                        "sphere { <50, 5, 0>, 1 pigment { rgb 0.25 } }");
    const struct gather gather = { .lamps = &(struct lamps){ .quality = 9 } };
    const struct ray down[] = { { { 0.5, 9, 0.5 }, { 0, -1, 0 } },
                                { { 1.5, 9, 0.5 }, { 0, -1, 0 } },
                                { { 50, 9, 0 }, { 0, -1, 0 } } };
    double seen[3];
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct intersection at;
        struct surface surface;
        assert_true(world_closest(all->world, &down[i], 0, RAY_CAMERA, &at));
        gather_surface(&gather, &down[i], &at, &surface);
        gather_paint(&surface, 1.5);
        seen[i] = surface.layer[0].pigment.r;
    }
    assert_true(seen[0] > 0.2 && seen[0] < 0.8);
    assert_true(fabs(seen[0] + seen[1] - 1) < 1e-9);
    assert_true(seen[2] == 0.25);
    scene_world_free(all);
}

/* A scene's lamps, and who asks them. */
struct asked {
    struct scene_world *all;
    struct lamps lamps;
    struct worker worker;
};

static struct asked asked_new(const char *text)
{
    struct scene_world *all = scene_world_new(text);
    return (struct asked){ all,
                           lamps_new(all->world, all->scene, 9, 0),
                           { .scratch = arena_new(0) } };
}

static void asked_free(struct asked *asked)
{
    arena_free(asked->worker.scratch);
    lamps_free(&asked->lamps);
    scene_world_free(asked->all);
}

/* The mean of so many drawn lamps. */
static rgb asked_mean(struct asked *asked, const struct lit_place *lit,
                      uint32_t samples)
{
    rgb drawn = rgb_grey(0);
    for (uint32_t i = 0; i < samples; i++) {
        struct draws draws = { 7, i };
        drawn = rgb_add(drawn, drawn_lamp_light(&asked->lamps, &asked->worker,
                                                &draws, 0, lit));
    }
    return rgb_scale(drawn, 1.0 / samples);
}

/* In the mean the drawn lamp is all of them, behind shadows too. */
static void test_drawn(void **state)
{
    struct asked asked = asked_new(
        "#declare I = 0; #while (I < 40) light_source { <I - 20, 9, I / 5>, "
        "<0.1, 0.02 * I, 0.5> } #declare I = I + 1; #end "
        "box { <-9, 5, -9>, <0, 6, 9> }");
    const struct lamps *lamps = &asked.lamps;
    vec3 place = { 0.5, 0, 0.3 }, up = { 0, 1, 0 };
    const struct lit_place lit = { .point = place, .normal = up };
    rgb all_of_them = rgb_grey(0);
    (void)state;
    for (size_t i = 0; i < lamps->count; i++) {
        struct lamp_target target = { .point = place };
        const struct lamp *lamp = &lamps->items[i];
        lamp_look(lamp, lamp->light->location, place, &target.view);
        double cosine = vec3_dot(target.view.direction, up);
        rgb share = lamps_share_point(lamps, lamp, &asked.worker, &target);
        all_of_them =
            rgb_add(all_of_them,
                    rgb_scale(rgb_mul(lamp->light->colour, share), cosine));
    }
    rgb drawn = asked_mean(&asked, &lit, 8192);
    assert_true(rgb_peak(all_of_them) > 1);
    assert_true(fabs(drawn.r - all_of_them.r) < 0.02 * all_of_them.r);
    assert_true(fabs(drawn.g - all_of_them.g) < 0.02 * all_of_them.g);
    assert_true(fabs(drawn.b - all_of_them.b) < 0.02 * all_of_them.b);
    struct draws draws = { 7, 0 };
    rgb each = each_lamp_light(lamps, &asked.worker, &draws, 0, &lit);
    assert_true(rgb_peak(rgb_sub(each, all_of_them)) < 1e-9);
    asked_free(&asked);
}

/* Of an area light all counts that is between its grid's points: these are
 * hidden, and three quarters of the rest are not. */
static void test_drawn_area(void **state)
{
    struct asked asked =
        asked_new("light_source { <0, 9, 0>, 1 area_light 4*x, 4*z, 2, 2 } "
                  "box { <4/3, 7.99, -9>, <9, 8, 9> } "
                  "box { <-9, 7.99, -9>, <-4/3, 8, 9> }");
    const struct lit_place lit = { .normal = { 0, 1, 0 } };
    (void)state;
    assert_true(fabs(asked_mean(&asked, &lit, 4096).r - 0.75) < 0.01);
    asked_free(&asked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_open),      cmocka_unit_test(test_room),
        cmocka_unit_test(test_beyond),    cmocka_unit_test(test_outlook),
        cmocka_unit_test(test_afford),    cmocka_unit_test(test_afford_dear),
        cmocka_unit_test(test_near_rays), cmocka_unit_test(test_own_rays),
        cmocka_unit_test(test_nets),      cmocka_unit_test(test_paint),
        cmocka_unit_test(test_drawn),     cmocka_unit_test(test_drawn_area),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
