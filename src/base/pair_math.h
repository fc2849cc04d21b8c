/* Sine, cosine and arc tangent of two numbers at a time, and of one to the same
 * bit: within 1e-15 of the true value, relatively but next to zeros of large
 * angles. The C library's differ from them, and from each other on different
 * systems, in the last bit. */
#ifndef BASE_PAIR_MATH_H
#define BASE_PAIR_MATH_H

#include "base/pair.h"

/* Angles in radians, of any size. */
pair pair_sin(pair x);
pair pair_cos(pair x);

/* As atan2(y, x): from -pi to pi. */
pair pair_atan2(pair y, pair x);

pair pair_sqrt(pair x);
pair pair_abs(pair x);

double lone_sin(double x);
double lone_cos(double x);
double lone_atan2(double y, double x);

#endif
