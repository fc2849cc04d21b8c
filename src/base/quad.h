/* Four doubles at a time: half an octet. What a longer loop needs of them fits
 * into the registers of a processor whose instructions are as wide; of vectors
 * that are wider than these gcc compares number by number, and keeps copies. */
#ifndef BASE_QUAD_H
#define BASE_QUAD_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "base/octet.h"

enum { QUAD = 4 };

typedef double quad __attribute__((vector_size(QUAD * sizeof(double))));

/* What comparing two of them gives: all bits set where it is so. */
typedef int64_t quad_bits __attribute__((vector_size(QUAD * sizeof(int64_t))));

/* `yes` where the bits are set, else `no`. */
INLINED quad quad_choose(quad_bits where, quad yes, quad no)
{
    return (quad)((where & (quad_bits)yes) | (~where & (quad_bits)no));
}

INLINED quad_bits quad_less(quad a, quad b)
{
    return a < b;
}

/* Whether any bit is set. */
INLINED bool quad_any(quad_bits bits)
{
    return (bits[0] | bits[1] | bits[2] | bits[3]) != 0;
}

/* Those of eight from that one on, and back. */
INLINED quad quad_of(const octet *all, int from)
{
    quad part;
    memcpy(&part, (const double *)all + from, sizeof part);
    return part;
}

INLINED void quad_into(octet *all, int from, quad part)
{
    memcpy((double *)all + from, &part, sizeof part);
}

INLINED quad_bits quad_bits_of(const octet_bits *all, int from)
{
    return (quad_bits)quad_of((const octet *)all, from);
}

INLINED void quad_bits_into(octet_bits *all, int from, quad_bits part)
{
    quad_into((octet *)all, from, (quad)part);
}

#endif
