/* Sine, cosine, arc tangent, e^x and logarithm of eight numbers at a time, and
 * of one to the same bit: within 1e-15 of the true value, relatively but next
 * to zeros of large angles. The C library's differ from them, and from each
 * other on different systems, in the last bit. */
#ifndef BASE_OCTET_MATH_H
#define BASE_OCTET_MATH_H

#include "base/octet.h"

/* Each of *x becomes its own sine, cosine, square root, size; angles are in
 * radians, of any size. */
void octet_sin(octet *x);
void octet_cos(octet *x);
void octet_sqrt(octet *x);
void octet_abs(octet *x);

/* The sine of each of `count` numbers, and y[i] becomes atan2(y[i], x[i]), to
 * the bit as above and below. */
void numbers_sin(double *x, int count);
void numbers_atan2(double *y, const double *x, int count);

/* e^x, where x beyond 708 counts as that, and below -708; the logarithm of what
 * is above 0, where less than 1e-300 counts as that. Of eight at a time only.
 */
void octet_exp(octet *x);
void octet_ln(octet *x);

/* *y becomes atan2(y, x): from -pi to pi. */
void octet_atan2(octet *y, const octet *x);

double lone_sin(double x);
double lone_cos(double x);
double lone_atan2(double y, double x);

#endif
