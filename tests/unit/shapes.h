/* Shapes from plain numbers, and random rays, for tests of geometry. */
#ifndef TESTS_UNIT_SHAPES_H
#define TESTS_UNIT_SHAPES_H

#include "harness.h"

#include "base/random.h"
#include "scene/primitive.h"

enum { SHAPE_NUMBERS = 64 };

/* Writes the arguments in the order the scene language has them; points
 * become 3 numbers each. FIELD_TERMS and FIELD_POINTS take all that is left:
 * `count` numbers in all. */
static inline void shape_fill(struct arena *arena, const struct field *field,
                              void *shape, const double *numbers, int count)
{
    const double *end = numbers + count;
    for (; field->name; field++) {
        void *at = (char *)shape + field->offset;
        if (field->kind == FIELD_FLOAT && numbers < end) {
            *(double *)at = *numbers++;
        } else if (field->kind == FIELD_INTEGER) {
            *(int *)at = (int)*numbers++;
        } else if (field->kind == FIELD_VECTOR) {
            *(vec3 *)at = (vec3){ numbers[0], numbers[1], numbers[2] };
            numbers += 3;
        } else if (field->kind == FIELD_VECTOR2) {
            memcpy(at, numbers, 2 * sizeof *numbers);
            numbers += 2;
        } else if (field->kind == FIELD_TERMS) {
            struct terms *terms = at;
            terms->count = (size_t)(end - numbers);
            terms->values = ARENA_ARRAY(arena, double, terms->count);
            memcpy(terms->values, numbers, terms->count * sizeof *numbers);
        } else if (field->kind == FIELD_POINTS ||
                   field->kind == FIELD_POINTS2) {
            struct points *points = at;
            points->count = (size_t)(end - numbers) / 3;
            points->items = ARENA_ARRAY(arena, vec3, points->count);
            memcpy(points->items, numbers, points->count * sizeof(vec3));
        }
    }
}

/* A shape ready for use; `problem` and `warning` as prepare() says. */
static inline void *shape_try(struct arena *arena, const char *name,
                              const double *numbers, int count,
                              const char **problem, const char **warning)
{
    const struct primitive *primitive = primitive_find(name);
    assert_non_null(primitive);
    void *shape = arena_alloc(arena, primitive->size);
    shape_fill(arena, primitive->arguments, shape, numbers, count);
    *problem = *warning = NULL;
    if (primitive->prepare)
        *problem = primitive->prepare(shape, arena, warning);
    return shape;
}

static inline void *shape_new(struct arena *arena, const char *name,
                              const double *numbers, int count)
{
    const char *problem, *warning;
    void *shape = shape_try(arena, name, numbers, count, &problem, &warning);
    assert_null(problem);
    assert_null(warning);
    return shape;
}

/* Numbers from a key: each call the next one in [low, high). */
struct dice {
    uint64_t key;
};

static inline double dice_between(struct dice *dice, double low, double high)
{
    dice->key = random_mix(dice->key);
    return low + (high - low) * random_unit(dice->key);
}

static inline vec3 dice_point(struct dice *dice, double size)
{
    double x = dice_between(dice, -size, size);
    double y = dice_between(dice, -size, size);
    double z = dice_between(dice, -size, size);
    return vec3_make(x, y, z);
}

/* From somewhere within 4 towards somewhere within 1.2, unit direction. */
static inline struct ray dice_ray(struct dice *dice)
{
    vec3 from = dice_point(dice, 4), to = dice_point(dice, 1.2);
    return (struct ray){ from, vec3_normalise(vec3_sub(to, from)) };
}

#endif
