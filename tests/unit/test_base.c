/* base/: arenas, arrays, affine maps, text distance, the parallel loop. */
#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/affine.h"
#include "base/array.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/save.h"
#include "base/text.h"

/* Of the heap, mapped, and between them. */
static const size_t block_sizes[] = { 0,       1,       1000,    1 << 20,
                                      4194303, 4194304, 9000000, 100 };
enum { BLOCK_SIZES = sizeof block_sizes / sizeof *block_sizes };

static void memory_is_zeroed_when_used_again(void **state)
{
    (void)state;
    for (int round = 0; round < 3; round++)
        for (int i = 0; i < BLOCK_SIZES; i++) {
            size_t size = block_sizes[i];
            unsigned char *bytes = memory_new(size);
            for (size_t k = 0; k < size; k++)
                assert_int_equal(bytes[k], 0);
            memset(bytes, 0xff, size);
            memory_free(bytes);
        }
    memory_free(NULL);
}

static void memory_keeps_bytes_when_resized(void **state)
{
    (void)state;
    for (int from = 0; from < BLOCK_SIZES; from++)
        for (int to = 0; to < BLOCK_SIZES; to++) {
            size_t before = block_sizes[from], after = block_sizes[to];
            unsigned char *bytes =
                from % 2 ? memory_new(before) : memory_resize(NULL, before);
            for (size_t k = 0; k < before; k++)
                bytes[k] = (unsigned char)(k % 251);
            bytes = memory_resize(bytes, after);
            for (size_t k = 0; k < before && k < after; k++)
                assert_int_equal(bytes[k], k % 251);
            memset(bytes, 0, after);
            memory_free(bytes);
        }
}

static void arena_keeps_what_it_gave(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    int *numbers[1000];
    for (int i = 0; i < 1000; i++) {
        numbers[i] = ARENA_ARRAY(arena, int, (size_t)i + 1);
        numbers[i][i] = i;
    }
    for (int i = 0; i < 1000; i++) {
        assert_int_equal(numbers[i][i], i);
        assert_true(i == 0 || numbers[i][0] == 0);
    }
    arena_free(arena);
}

static void arena_zeroes_after_reset(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    memset(arena_alloc(arena, 4000), 0xff, 4000);
    arena_reset(arena);
    const unsigned char *bytes = arena_alloc(arena, 4000);
    for (int i = 0; i < 4000; i++)
        assert_int_equal(bytes[i], 0);
    arena_free(arena);
}

static void arena_tells_its_limit(void **state)
{
    (void)state;
    struct arena *arena = arena_new(1000);
    arena_alloc(arena, 900);
    assert_false(arena_over_limit(arena));
    arena_alloc(arena, 900);
    assert_true(arena_over_limit(arena));
    arena_free(arena);
}

static void arena_resizes_what_came_last(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    char *first = arena_alloc(arena, 100), *last = arena_alloc(arena, 100);
    assert_false(arena_resize(arena, first, 100, 200));
    assert_true(arena_resize(arena, last, 100, 1000));
    memset(last, 0xff, 1000);
    assert_true(arena_resize(arena, last, 1000, 10));
    unsigned char *next = arena_alloc(arena, 1000);
    assert_ptr_equal(next, last + 16);
    for (int i = 0; i < 1000; i++)
        assert_int_equal(next[i], 0);
    assert_false(arena_resize(arena, next, 1000, (size_t)1 << 20));
    arena_free(arena);
}

static void array_gives_back_what_it_does_not_need(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct {
        int *items;
        size_t count, capacity;
    } list = { 0 };
    for (int i = 0; i < 1000; i++)
        *ARRAY_PUSH(arena, &list) = i;
    assert_true(arena_used(arena) < 2000 * sizeof(int));
    ARRAY_FIT(arena, &list);
    assert_int_equal(arena_used(arena), 1000 * sizeof(int));
    *ARRAY_PUSH(arena, &list) = 1000;
    for (int i = 0; i <= 1000; i++)
        assert_int_equal(list.items[i], i);
    arena_free(arena);
}

static void array_grows(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct {
        int *items;
        size_t count, capacity;
    } array = { 0 };
    for (int i = 0; i < 10000; i++)
        *ARRAY_PUSH(arena, &array) = i;
    for (int i = 0; i < 10000; i++)
        assert_int_equal(array.items[i], i);
    arena_free(arena);
}

static void near(vec3 a, vec3 b)
{
    assert_true(vec3_length(vec3_sub(a, b)) < 1e-12);
}

static void affine_rotates_as_povray(void **state)
{
    (void)state;
    affine z = affine_rotation(vec3_make(0, 0, 90));
    near(affine_point(&z, vec3_make(1, 0, 0)), vec3_make(0, 1, 0));
    affine y = affine_rotation(vec3_make(0, 90, 0));
    near(affine_point(&y, vec3_make(1, 0, 0)), vec3_make(0, 0, -1));
    affine x = affine_rotation(vec3_make(90, 0, 0));
    near(affine_point(&x, vec3_make(0, 1, 0)), vec3_make(0, 0, 1));
}

static void affine_inverts(void **state)
{
    (void)state;
    affine a =
        affine_compose(affine_translation(vec3_make(1, 2, 3)),
                       affine_compose(affine_rotation(vec3_make(10, 20, 30)),
                                      affine_scaling(vec3_make(1, -2, 0.5))));
    affine inverse;
    assert_true(affine_inverse(a, &inverse));
    vec3 p = vec3_make(0.3, -0.7, 11), q = affine_point(&a, p);
    near(affine_point(&inverse, q), p);
    affine flat = affine_scaling(vec3_make(1, 0, 1));
    assert_false(affine_inverse(flat, &inverse));
}

static void affine_box_holds_its_points(void **state)
{
    (void)state;
    affine a = affine_rotation(vec3_make(30, 40, 50));
    struct box3 box = { { -1, -2, -3 }, { 3, 2, 1 } };
    struct box3 image = affine_box(&a, box);
    for (uint64_t i = 0; i < 1000; i++) {
        vec3 p = { -1 + 4 * random_unit(random_key(1, i)),
                   -2 + 4 * random_unit(random_key(2, i)),
                   -3 + 4 * random_unit(random_key(3, i)) };
        assert_true(box3_contains(image, affine_point(&a, p)));
    }
    struct box3 half = { { -INFINITY, -INFINITY, -INFINITY },
                         { INFINITY, 0, INFINITY } };
    affine lift = affine_translation(vec3_make(0, 5, 0));
    assert_true(affine_box(&lift, half).high.y == 5);
    assert_false(box3_is_finite(affine_box(&lift, half)));
}

static void text_distance_counts_edits(void **state)
{
    (void)state;
    assert_int_equal(text_distance("pigmnt", "pigment"), 1);
    assert_int_equal(text_distance("spehre", "sphere"), 1);
    assert_int_equal(text_distance("Sphere", "sphere"), 0);
    assert_int_equal(text_distance("", "abc"), 3);
    struct text_nearest nearest = text_nearest_start("tranlsate");
    text_nearest_try(&nearest, "rotate");
    text_nearest_try(&nearest, "translate");
    assert_string_equal(nearest.best, "translate");
    nearest = text_nearest_start("wombat");
    text_nearest_try(&nearest, "sphere");
    assert_null(nearest.best);
    nearest = text_nearest_start("of"); /* as near to both */
    text_nearest_try(&nearest, "if");
    text_nearest_try(&nearest, "off");
    text_nearest_try(&nearest, "or");
    assert_string_equal(nearest.best, "off");
    nearest = text_nearest_start("Colors"); /* none is nearer than the same */
    text_nearest_try(&nearest, "colors");
    text_nearest_try(&nearest, "golds");
    assert_string_equal(nearest.best, "colors");
}

static void text_numbers_are_written_out(void **state)
{
    (void)state;
    assert_string_equal(NUMBER_TEXT(1e6), "1000000");
    assert_string_equal(NUMBER_TEXT(-1234567), "-1234567");
    assert_string_equal(NUMBER_TEXT(123456789012.0), "123456789012");
    assert_string_equal(NUMBER_TEXT(1e-6), "0.000001");
    assert_string_equal(NUMBER_TEXT(-1.5e-7), "-0.00000015");
    assert_string_equal(NUMBER_TEXT(0.1), "0.1");
    assert_string_equal(NUMBER_TEXT(0.1 + 0.2), "0.3");
    assert_string_equal(NUMBER_TEXT(0), "0");
    assert_string_equal(NUMBER_TEXT(1e300), "1e+300");
    assert_string_equal(NUMBER_TEXT(1e-300), "1e-300");
    assert_string_equal(NUMBER_TEXT(HUGE_VAL), "inf");
}

static void mark(void *context, size_t item, unsigned thread)
{
    (void)thread;
    ((unsigned char *)context)[item]++;
}

static void parallel_does_each_item_once(void **state)
{
    (void)state;
    unsigned char marks[5000] = { 0 };
    assert_true(parallel_run(4, sizeof marks, NULL, mark, marks));
    for (size_t i = 0; i < sizeof marks; i++)
        assert_int_equal(marks[i], 1);
    atomic_int stop = 1;
    assert_false(parallel_run(4, 10, &stop, mark, marks));
}

/* In another process, since it ends; the address sanitizer ends it in its own
 * way. */
static void save_leaves_nothing_without_memory(void **state)
{
    (void)state;
#ifndef __SANITIZE_ADDRESS__
    char directory[] = "/tmp/test_base.XXXXXX", path[80], error[100];
    assert_non_null(mkdtemp(directory));
    snprintf(path, sizeof path, "%s/picture", directory);
    pid_t child = fork();
    if (child == 0) {
        struct save *save = save_start(path, error, sizeof error);
        if (save && save_put(save, path, sizeof path, error, sizeof error) &&
            rmdir(directory) != 0) /* there is something in it */
            memory_new(SIZE_MAX / 2);
        _exit(99);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 1);
    assert_int_equal(rmdir(directory), 0);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_is_zeroed_when_used_again),
        cmocka_unit_test(memory_keeps_bytes_when_resized),
        cmocka_unit_test(arena_keeps_what_it_gave),
        cmocka_unit_test(arena_zeroes_after_reset),
        cmocka_unit_test(arena_tells_its_limit),
        cmocka_unit_test(arena_resizes_what_came_last),
        cmocka_unit_test(array_gives_back_what_it_does_not_need),
        cmocka_unit_test(array_grows),
        cmocka_unit_test(affine_rotates_as_povray),
        cmocka_unit_test(affine_inverts),
        cmocka_unit_test(affine_box_holds_its_points),
        cmocka_unit_test(text_distance_counts_edits),
        cmocka_unit_test(text_numbers_are_written_out),
        cmocka_unit_test(parallel_does_each_item_once),
        cmocka_unit_test(save_leaves_nothing_without_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
