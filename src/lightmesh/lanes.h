/* Eight floats at a time, in the vectors that gcc and clang both know; a
 * processor without such wide ones does them in parts. Each operation rounds
 * as single floats do: all processors come to the same result. */
#ifndef LIGHTMESH_LANES_H
#define LIGHTMESH_LANES_H

#include <stdint.h>

#include "base/clones.h"

enum { LANES = 8 };

typedef float lanes __attribute__((vector_size(4 * LANES), aligned(4)));
typedef int32_t lanes_mask __attribute__((vector_size(4 * LANES), aligned(4)));

/* Functions that pass them are INLINED in their callers, which exist twice: for
 * processors with AVX2 and for all. */
#ifdef __x86_64__
#define LANES_WIDE       __attribute__((target("avx2")))
#define lanes_are_wide() __builtin_cpu_supports("avx2")
#else
#define LANES_WIDE
#define lanes_are_wide() 0
#endif

INLINED lanes lanes_load(const float *from)
{
    return *(const lanes *)from;
}

/* `yes` where the mask is set, else `no`. */
INLINED lanes lanes_choose(lanes_mask mask, lanes yes, lanes no)
{
    return (lanes)((mask & (lanes_mask)yes) | (~mask & (lanes_mask)no));
}

INLINED lanes lanes_abs(lanes x)
{
    return (lanes)((lanes_mask)x & 0x7fffffff);
}

INLINED lanes lanes_min(lanes a, lanes b)
{
    return lanes_choose(a < b, a, b);
}

INLINED lanes lanes_max(lanes a, lanes b)
{
    return lanes_choose(a > b, a, b);
}

INLINED lanes_mask lanes_whole(lanes x)
{
    return __builtin_convertvector(x, lanes_mask);
}

#endif
