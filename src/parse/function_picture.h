/* What a function says of the points of a picture that is made of it, for
 * image_map { function W, H { ... } } and height fields. */
#ifndef PARSE_FUNCTION_PICTURE_H
#define PARSE_FUNCTION_PICTURE_H

#include "scene/function.h"
#include "scene/spots.h"

enum { FUNCTION_PICTURE_STEPS = 1000000000 }; /* of all points together */

struct function_picture {
    const struct function *function;
    int width, height;
    unsigned long steps_left; /* 0: it takes too long */
};

/* Some points of a row. */
struct function_piece {
    int count;
    double values[SPOTS_MAX];   /* of a function of numbers, */
    double parts[SPOTS_MAX][5]; /* of one of colours: function->values */
};

struct function_picture function_picture_new(const struct function *function,
                                             int width, int height);

/* What it says from column x on, of SPOTS_MAX points or as many as are left in
 * row y: x and y from 0 to 1, z is 0. False: it takes too long. */
bool function_picture_piece(struct function_picture *picture, int x, int y,
                            struct function_piece *piece);

#endif
