/* The complex functions that hypercomplex Julia sets iterate. */
#ifndef SCENE_JULIA_FUNCTION_H
#define SCENE_JULIA_FUNCTION_H

#include <complex.h>
#include <math.h>

#include "scene/julia_octets.h"

/* glibc has it for gcc alone. */
#if !defined CMPLX && defined __clang__
#define CMPLX(re, im) __builtin_complex((double)(re), (double)(im))
#endif

/* |z| and its square, for numbers far from overflow. */
static inline double complex_square(double complex z)
{
    return creal(z) * creal(z) + cimag(z) * cimag(z);
}

static inline double complex_size(double complex z)
{
    return sqrt(complex_square(z));
}

struct julia_function {
    const char *name; /* the keyword */
    /* `power` is that of pwr(). */
    double complex (*value)(double complex z, double complex power);
    double complex (*slope)(double complex z, double complex power);
    /* How far apart the values at z and at most `e` from it can be, at most:
     * HUGE_VAL where a cut or a pole is so near. */
    double (*spread)(double complex z, double e, double complex power);
    julia_octets *octets; /* the value, of eight at once */
};

/* The function of this name, or NULL. */
const struct julia_function *julia_function_find(const char *name);

/* Number `index`, or NULL past the end. */
const struct julia_function *julia_function_at(int index);

#endif
