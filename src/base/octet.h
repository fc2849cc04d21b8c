/* Eight doubles at a time. A processor without such wide instructions does them
 * in parts: functions of them are CLONES, and hand them on by pointers, since
 * how they are handed on by value differs between processors. */
#ifndef BASE_OCTET_H
#define BASE_OCTET_H

#include <stdbool.h>
#include <stdint.h>

#include "base/clones.h"

enum { OCTET = 8 };

typedef double octet __attribute__((vector_size(OCTET * sizeof(double))));

/* What comparing two of them gives: all bits set where it is so. */
typedef int64_t octet_bits
    __attribute__((vector_size(OCTET * sizeof(int64_t))));

/* `yes` where the bits are set, else `no`. */
INLINED octet octet_choose(octet_bits where, octet yes, octet no)
{
    return (octet)((where & (octet_bits)yes) | (~where & (octet_bits)no));
}

/* Where a < b: by the sign of the difference, since of a comparison of vectors
 * this wide gcc 12 makes eight comparisons of numbers. -0 is less than 0, and
 * of what is no number anything may be said. */
INLINED octet_bits octet_less(octet a, octet b)
{
    return (octet_bits)(a - b) >> 63;
}

/* Whether any bit is set. */
INLINED bool octet_any(octet_bits bits)
{
    int64_t any = 0;
    for (int i = 0; i < OCTET; i++)
        any |= bits[i];
    return any != 0;
}

#endif
