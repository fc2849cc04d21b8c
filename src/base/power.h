/* Powers as lamps, finishes, interiors and waves have them: most exponents are
 * whole numbers, for which multiplying takes a third of the time of pow. */
#ifndef BASE_POWER_H
#define BASE_POWER_H

#include <math.h>
#include <stdbool.h>

/* Exponents up to this are made by multiplying. */
enum { POWER_WHOLE = 4096 };

static inline bool power_is_whole(double exponent)
{
    return exponent >= 0 && exponent <= POWER_WHOLE &&
           exponent == (int)exponent;
}

static inline double power_of(double base, double exponent)
{
    double power = 1;
    if (!power_is_whole(exponent))
        return pow(base, exponent);
    for (unsigned left = (unsigned)exponent; left; left >>= 1) {
        power = left & 1 ? power * base : power;
        base *= base;
    }
    return power;
}

#endif
