/* The complex functions of julia_function.h, of eight numbers at a time. */
#ifndef SCENE_JULIA_OCTETS_H
#define SCENE_JULIA_OCTETS_H

#include "base/octet.h"

/* Real and imaginary parts. */
struct complex_octet {
    octet re, im;
};

/* Each number becomes its own value; `power` is that of pwr(). */
typedef void julia_octets(struct complex_octet *z, const double power[2]);

julia_octets octets_sqr, octets_reciprocal, octets_exp, octets_ln, octets_pwr,
    octets_sin, octets_cos, octets_tan, octets_sinh, octets_cosh, octets_tanh,
    octets_asin, octets_acos, octets_atan, octets_asinh, octets_acosh,
    octets_atanh;

#endif
