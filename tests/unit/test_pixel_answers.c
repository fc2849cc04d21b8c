/* Answers that the rays of a pixel share. */
#include "harness.h"

#include "lightmesh/pixel_answers.h"
#include "shade/first_hits.h"

/* A place on the plane y = 0, seen in a pixel. */
static struct receiver place_in(const struct picture_place *pixel, double x)
{
    const vec3 up = vec3_make(0, 1, 0);
    return (struct receiver){
        .point = vec3_make(x, 0, 0),
        .side = up,
        .normal = up,
        .pixel = pixel,
        .weight = 1,
    };
}

static bool told(const struct pixel_answers *answers, unsigned worker,
                 const struct receiver *receiver)
{
    struct indirect_share share = { .open = 0 };
    const struct worker asker = { .number = worker };
    bool found = pixel_answers_find(answers, &asker, receiver, &share);
    if (found)
        assert_true(share.open == 0.5 && share.light.g == 3);
    return found;
}

static void what_is_beside_in_the_pixel_has_the_same_answer(void **state)
{
    (void)state;
    struct pixel_answers *answers = pixel_answers_new(2);
    const struct worker worker = { .number = 1 };
    const struct picture_place here = { .pixel = 7 }, other = { .pixel = 8 },
                               only = { .pixel = 0 };
    const struct indirect_share share = { rgb_grey(3), 0.5 };
    struct receiver first = place_in(&here, 0), next = place_in(&here, 0.9);
    assert_false(told(answers, 1, &first));
    pixel_answers_keep(answers, &worker, &first, 1, &share);
    assert_true(told(answers, 1, &first));
    assert_true(told(answers, 1, &next));
    assert_false(told(answers, 0, &next)); /* another worker */
    assert_false(told(answers, 2, &next)); /* one that it doesn't know */
    next.side = next.normal = vec3_make(0, 0, 1);
    assert_false(told(answers, 1, &next)); /* another side */
    next = place_in(&here, 0.9);
    next.normal = vec3_normalise(vec3_make(1, 1, 0));
    assert_false(told(answers, 1, &next)); /* a bump */
    next = place_in(&here, 0.5);
    next.point.y = 0.5;
    assert_false(told(answers, 1, &next)); /* a step above */
    next = place_in(&here, 1.1);
    assert_false(told(answers, 1, &next)); /* too far off */
    next = place_in(&here, 0.9);
    next.weight = 1e-6;
    assert_false(told(answers, 1, &next)); /* asked less exactly */
    next = place_in(&only, 0);
    pixel_answers_keep(answers, &worker, &next, 1, &share);
    assert_false(told(answers, 1, &next)); /* its pixel's only ray */
    next = place_in(&other, 0);
    assert_false(told(answers, 1, &next)); /* another pixel */
    pixel_answers_free(answers);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_beside_in_the_pixel_has_the_same_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
