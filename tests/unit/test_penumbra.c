/* lightmesh/penumbra and the shafts behind it: what pixels share of area lights
 * is what each of them would have found. */
#include "harness.h"

#include <math.h>

#include "lightmesh/penumbra.h"
#include "stage.h"

/* Things in front of a wall and over a floor, lamps of several kinds. */
static const char things[] =
    "camera { location <0,3,-8> look_at <0,.3,0> angle 20 }\n"
    "plane { y, 0 } box { <-6,0,4>, <6,5,4.2> }\n"
    "box { <-6,0,-9>, <-2.5,.05,4> } box { <-2.5,0,-9>, <6,.05,4> }\n"
    "sphere { <-2,1.6,0>, .8 } torus { 1, .3 translate <3,1.5,0> }\n"
    "cylinder { <0,0,1>, <0,3,1>, .08 } cone { <2,0,2>, .7, <2,2,2>, 0 }\n"
    "box { <.2,1.4,-1.2>, <1.6,1.5,0> rotate 20*y }\n"
    "mesh { triangle { <-1,.8,-2>, <-.2,1.8,-2>, <-1,1.6,-1> } }\n"
    "difference { box { <-4.5,.1,1>, <-3.5,2.5,2> } "
    "             cylinder { <-4,1.2,0>, <-4,1.2,3>, .4 } }\n"
    "sphere { <3.5,.6,-2>, .5 pigment { rgbt <.2,1,.2,.6> } }\n"
    "light_source { <-3,6,-3> rgb 1 area_light 3*x, 3*z, 9, 9 adaptive 1 }\n"
    "light_source { <4,5,-4> rgb .5 spotlight point_at 0 falloff 40\n"
    "  area_light 2*x, 2*y, 5, 5 circular orient jitter }\n"
    "light_source { <0,9,-2> rgb .2 parallel point_at 0\n"
    "  area_light 3*x, 2*z, 5, 5 adaptive 2 }\n"
    "light_source { <0,9,-2> rgb .2 area_light 2*x, z, 9, 1 adaptive 1 }\n"
    "light_source { <0,3,-7> rgb .2 }\n"
    "light_source { <1,3,-7> rgb .2 area_light x, y, 3, 3 shadowless }\n"
    "light_source { <1,3,-7> rgb .2 area_light x, y, 3, 3 media_attenuation on "
    "}\n";

enum { TAKEN = 4 }; /* the first of them */

static struct penumbras *stage_penumbras(struct stage *stage, unsigned threads)
{
    return penumbras_new(&stage->lamps, &stage->all->scene->camera,
                         &stage->hits, stage->pointers, threads);
}

/* Shares known, and how they differ from those asked for. */
struct tally {
    int known, partly, wrong;
    double sum;
};

static void compare(struct stage *stage, const struct penumbras *penumbras,
                    int x, int y, struct tally *tally)
{
    struct stage_seen seen;
    if (!stage_meet(stage, x, y, &seen))
        return;
    for (size_t i = 0; i < stage->lamps.count; i++) {
        const struct lamp *lamp = &stage->lamps.items[i];
        struct lamp_target target = { .point = seen.at.point,
                                      .leaf = seen.at.leaf,
                                      .face = seen.at.face };
        rgb share;
        bool there =
            lamp_look(lamp, lamp->light->location, seen.at.point, &target.view);
        if (!there ||
            vec3_dot(target.view.direction, seen.receiver.side) <= 0 ||
            !penumbras_share(penumbras, &seen.receiver, lamp, &share))
            continue;
        assert_in_range(i, 0, TAKEN - 1);
        rgb asked =
            lamps_share_fine(&stage->lamps, lamp, &stage->workers[0], &target);
        double off = fmax(fabs(share.r - asked.r), fabs(share.g - asked.g));
        tally->known++;
        tally->partly += asked.g > 0 && asked.g < 1;
        tally->wrong += off > 0.05;
        tally->sum += off;
    }
}

static void test_shares_as_asked(void **state)
{
    struct stage stage;
    struct tally tally = { 0 };
    (void)state;
    stage_start(&stage, things);
    stage.lamps.soft = 1; /* each is looked at as closely as one alone */
    struct penumbras *penumbras = stage_penumbras(&stage, 2);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            compare(&stage, penumbras, x, y, &tally);
    assert_true(tally.known > 10000 && tally.partly > 3000);
    assert_true(penumbras_count(penumbras) < (size_t)tally.known / 4);
    assert_in_range(tally.wrong, 0, 20);
    assert_true(tally.sum < 0.003 * tally.known);
    penumbras_free(penumbras);
    stage_end(&stage);
}

/* What is known at the pixels of an area, in their order. */
static void take_shares(const struct stage *stage,
                        const struct penumbras *penumbras, int left, int top,
                        int edge, rgb *out)
{
    for (int y = top; y < top + edge; y++)
        for (int x = left; x < left + edge; x++)
            for (size_t i = 0; i < TAKEN; i++, out++) {
                struct stage_seen seen;
                *out = rgb_grey(-1);
                if (stage_meet(stage, x, y, &seen))
                    penumbras_share(penumbras, &seen.receiver,
                                    &stage->lamps.items[i], out);
            }
}

/* The same of a part of the picture, with its apron, and for any number of
 * threads. */
static void test_parts_and_threads(void **state)
{
    enum { LEFT = 41, TOP = 31, EDGE = 20, APRON = FIRST_HITS_APRON };
    static rgb whole[EDGE * EDGE * TAKEN], part[EDGE * EDGE * TAKEN];
    struct stage stage;
    (void)state;
    stage_start(&stage, things);
    struct penumbras *penumbras = stage_penumbras(&stage, 1);
    take_shares(&stage, penumbras, LEFT, TOP, EDGE, whole);
    penumbras_free(penumbras);
    free(stage.hits.at);
    stage_look(&stage, LEFT - APRON, TOP - APRON, EDGE + 2 * APRON,
               EDGE + 2 * APRON);
    penumbras = stage_penumbras(&stage, THREADS);
    take_shares(&stage, penumbras, LEFT, TOP, EDGE, part);
    penumbras_free(penumbras);
    assert_memory_equal(whole, part, sizeof whole);
    stage_end(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares_as_asked),
        cmocka_unit_test(test_parts_and_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
