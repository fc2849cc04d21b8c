/* How far apart two colours look, for antialiasing: the sum of the differences
 * of their components, each to a power. Most pairs are decided by a table. The
 * power is that of light, as POV-Ray's is: numbers of a working space of gamma
 * 2.2 get 2.2 times the exponent, those of sRGB are decoded first. */
#ifndef RENDER_PERCEIVED_H
#define RENDER_PERCEIVED_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum {
    PERCEIVED_PARTS = 256,           /* of numbers from 1 to 2 */
    PERCEIVED_LEAST_EXPONENT = -149, /* of a float */
    PERCEIVED_EXPONENTS = 278,
    PERCEIVED_BEGINNINGS = 512,
};

/* So steep that floats which differ at all differ by more than any threshold;
 * none times it is still none. */
#define PERCEIVED_UNKNOWN 1e300

struct perceived {
    double exponent;
    bool decoded; /* by the sRGB curve before the power */
    double error; /* of the table, relative, at most */
    bool rough;   /* the table is too rough to decide anything */
    double mantissa[PERCEIVED_PARTS + 1];
    double power[PERCEIVED_EXPONENTS]; /* of 2, to the exponent */
    /* Of floats that begin with these 9 bits, sign and exponent: how steep the
     * power is at most; PERCEIVED_UNKNOWN: it isn't known. */
    double slope[PERCEIVED_BEGINNINGS];
};

/* Of values to the power `exponent`, above 0. */
void perceived_fill(struct perceived *table, double exponent);

/* Of sRGB values. Slower: no table is made of them. */
void perceived_fill_srgb(struct perceived *table, double exponent);

/* For perceived_differ: the same, whatever the numbers are. */
bool perceived_differ_closely(const struct perceived *table, const float *a,
                              const float *b, double more, double threshold);

/* Where a power below 1 or, with `over` all ones, above it is steepest between
 * two numbers: a beginning. */
static inline uint32_t perceived_steepest(float a, float b, uint32_t over)
{
    float low = a < b ? a : b, high = a > b ? a : b;
    uint32_t least, most;
    memcpy(&least, &low, sizeof least);
    memcpy(&most, &high, sizeof most);
    return ((least & ~over) | (most & over)) >> 23;
}

static inline uint32_t perceived_over(const struct perceived *table)
{
    return table->exponent > 1 ? UINT32_MAX : 0;
}

/* No less than the difference; or NaN. Nobody can predict which is the greater
 * one, so there are no branches. */
static inline double perceived_most(const double *slopes, float a, float b,
                                    uint32_t over)
{
    return fabs((double)a - (double)b) * slopes[perceived_steepest(a, b, over)];
}

/* Whether the sum over three components of |a^exponent - b^exponent|, and
 * `more`, reaches the threshold, as all do that of 0; values below 0 count as
 * 0. Says exactly what pow() would say. Most neighbours are so much alike that
 * slopes decide. */
static inline bool perceived_differ(const struct perceived *table,
                                    const float *a, const float *b, double more,
                                    double threshold)
{
    const uint32_t over = perceived_over(table);
    double most = more + perceived_most(table->slope, a[0], b[0], over) +
                  perceived_most(table->slope, a[1], b[1], over) +
                  perceived_most(table->slope, a[2], b[2], over);
    return !(most * (1 + 1e-9) < threshold) &&
           perceived_differ_closely(table, a, b, more, threshold);
}

/* Pixels side by side. */
enum { PERCEIVED_ROW = 32 };

struct perceived_limit {
    double opacity; /* how much a difference of opacity counts */
    double threshold;
};

/* Those of a row, bit by bit, that may differ from the others: most are sure
 * not to. */
uint32_t perceived_may_differ(const struct perceived *table,
                              const float (*a)[4], const float (*b)[4],
                              struct perceived_limit limit);

#endif
