/* As fmin and fmax, but one instruction each; if one is no number the second is
 * taken. */
#ifndef BASE_LESSER_H
#define BASE_LESSER_H

static inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

static inline double greater(double a, double b)
{
    return a > b ? a : b;
}

#endif
