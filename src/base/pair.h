/* Two doubles at a time, of which every machine has instructions. */
#ifndef BASE_PAIR_H
#define BASE_PAIR_H

#ifdef __SSE2__
#include <emmintrin.h>
#endif

enum { PAIR = 2 };

typedef double pair __attribute__((vector_size(PAIR * sizeof(double))));

static inline pair pair_of(double value)
{
    return (pair){ value, value };
}

static inline pair pair_at(const double *two)
{
    return (pair){ two[0], two[1] };
}

/* a < b ? a : b and a > b ? a : b of both: compilers don't find these
 * instructions. */
static inline pair pair_min(pair a, pair b)
{
#ifdef __SSE2__
    return (pair)_mm_min_pd((__m128d)a, (__m128d)b);
#else
    return (pair){ a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1] };
#endif
}

static inline pair pair_max(pair a, pair b)
{
#ifdef __SSE2__
    return (pair)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    return (pair){ a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1] };
#endif
}

/* Bit by bit whether a <= b. */
static inline int pair_ordered(pair a, pair b)
{
#ifdef __SSE2__
    return _mm_movemask_pd(_mm_cmple_pd((__m128d)a, (__m128d)b));
#else
    return (a[0] <= b[0]) | (a[1] <= b[1]) << 1;
#endif
}

#endif
