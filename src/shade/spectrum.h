/* White light in parts, as glass with dispersion divides it. */
#ifndef SHADE_SPECTRUM_H
#define SHADE_SPECTRUM_H

#include "base/rgb.h"

/* The colour of part `number` of `parts` equal ones, red first; together they
 * are nearly white (measured). */
rgb spectrum_part(int number, int parts);

/* Where the middle of it is: 0 is the reddest, 1 the most violet. */
static inline double spectrum_place(int number, int parts)
{
    return (number + 0.5) / parts;
}

#endif
