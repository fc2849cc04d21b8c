/* How far apart two colours look, for antialiasing: the sum of the differences
 * of their components, each to a power. Most pairs are decided by a table. The
 * power is that of light, as POV-Ray's is: numbers of a working space of gamma
 * 2.2 get 2.2 times the exponent, those of sRGB are decoded first. */
#ifndef RENDER_PERCEIVED_H
#define RENDER_PERCEIVED_H

#include <stdbool.h>

enum {
    PERCEIVED_PARTS = 256,           /* of numbers from 1 to 2 */
    PERCEIVED_LEAST_EXPONENT = -149, /* of a float */
    PERCEIVED_EXPONENTS = 278,
    PERCEIVED_BEGINNINGS = 512,
};

struct perceived {
    double exponent;
    bool decoded; /* by the sRGB curve before the power */
    double error; /* of the table, relative, at most */
    bool rough;   /* the table is too rough to decide anything */
    double mantissa[PERCEIVED_PARTS + 1];
    double power[PERCEIVED_EXPONENTS]; /* of 2, to the exponent */
    /* Of floats that begin with these 9 bits, sign and exponent: how steep the
     * power is at most; INFINITY: it isn't known. */
    double slope[PERCEIVED_BEGINNINGS];
};

/* Of values to the power `exponent`, above 0. */
void perceived_fill(struct perceived *table, double exponent);

/* Of sRGB values. Slower: no table is made of them. */
void perceived_fill_srgb(struct perceived *table, double exponent);

/* Whether the sum over three components of |a^exponent - b^exponent|, and
 * `more`, is above the threshold; values below 0 count as 0. Says exactly what
 * pow() would say. */
bool perceived_differ(const struct perceived *table, const float *a,
                      const float *b, double more, double threshold);

#endif
