/* What functions are made of besides arithmetic: patterns, pigments, and those
 * of functions.inc. */
#ifndef SCENE_FUNCTION_FIELD_H
#define SCENE_FUNCTION_FIELD_H

#include "base/arena.h"
#include "scene/function.h"

struct pattern;
struct pigment;

enum { FIELD_GREY = 5 }; /* part of a colour, after its five numbers */

/* The pattern's value, of a block pattern the block's number. */
const struct function_field *field_of_pattern(struct arena *arena,
                                              const struct pattern *pattern);
/* One part of the pigment's colour. */
const struct function_field *
field_of_pigment(struct arena *arena, const struct pigment *pigment, int part);

enum { INTERNAL_NOISE3D = 76 }; /* the number of f_noise3d, a pattern */

/* One of functions.inc, by the number of its internal(). */
struct internal_function {
    int number, arguments;
    double (*value)(const double *arguments);
};

/* NULL: glim has none of this number. */
const struct internal_function *internal_find(int number);

#endif
