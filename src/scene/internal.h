/* The functions that functions.inc declares by number: internal(61) is
 * f_sphere. Their formulas were measured. */
#ifndef SCENE_INTERNAL_H
#define SCENE_INTERNAL_H

#include "base/octet.h"

struct internal_function {
    int number, arguments;
    /* arguments[0..2] are x, y and z. */
    double (*value)(const double *arguments);
    /* The same, to the bit, for up to OCTET points at once, into the first
     * argument; or NULL. */
    void (*values)(octet *arguments, int count);
};

/* The number of what is not in the tables: a pattern. */
enum { INTERNAL_NOISE3D = 76 };

/* NULL: there is none of this number. */
const struct internal_function *internal_find(int number);

/* Their tables, each ending with arguments 0: algebraic surfaces, other shapes,
 * sums of noise. */
extern const struct internal_function internal_algebraic[];
extern const struct internal_function internal_shapes[];
extern const struct internal_function internal_noises[];

#endif
