/* Where a point is between the planes of the integer lattice, and what the
 * corners of its cell weigh: for every noise on a lattice. */
#ifndef SCENE_NOISE_CELL_H
#define SCENE_NOISE_CELL_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/pair.h"

/* The lattice plane below a coordinate. Far beyond 2^40 a coordinate has no
 * fraction left and any number does. */
static inline int64_t plane_below(double *coordinate)
{
    double c = *coordinate;
    if (!(fabs(c) < 0x1p40))
        *coordinate = c = isfinite(c) ? fmod(c, 0x1p40) : 0;
    int64_t low = (int64_t)c;
    return low - (c < (double)low);
}

/* From 0 at one plane to 1 at the next, level at both. */
static inline float plane_blend(float t)
{
    return t * t * (3 - 2 * t);
}

/* Of the corner on the upper planes where these are said. */
static inline float corner_weight(const float blend[3], bool x, bool y, bool z)
{
    return (x ? blend[0] : 1 - blend[0]) * (y ? blend[1] : 1 - blend[1]) *
           (z ? blend[2] : 1 - blend[2]);
}

/* ---- four coordinates at a time ---- */

enum { FOUR = 4 };

typedef float floats __attribute__((vector_size(4 * FOUR)));
typedef uint32_t planes __attribute__((vector_size(4 * FOUR)));

struct four {
    pair low, high;
};

static inline double four_get(struct four four, int i)
{
    return i < PAIR ? four.low[i] : four.high[i - PAIR];
}

/* The planes below, and how far above them the coordinates are. What is beyond
 * 2^31 has a plane that planes_lost finds. */
static inline planes planes_below(struct four at, floats *place)
{
#ifdef __SSE2__
    __m128d a = (__m128d)at.low, b = (__m128d)at.high;
    __m128i of_a = _mm_cvttpd_epi32(a), of_b = _mm_cvttpd_epi32(b);
    __m128d over_a = _mm_cmplt_pd(a, _mm_cvtepi32_pd(of_a));
    __m128d over_b = _mm_cmplt_pd(b, _mm_cvtepi32_pd(of_b));
    __m128 over = _mm_shuffle_ps(_mm_castpd_ps(over_a), _mm_castpd_ps(over_b),
                                 _MM_SHUFFLE(2, 0, 2, 0));
    __m128i low =
        _mm_add_epi32(_mm_unpacklo_epi64(of_a, of_b), _mm_castps_si128(over));
    a = _mm_sub_pd(a, _mm_cvtepi32_pd(low));
    b = _mm_sub_pd(b, _mm_cvtepi32_pd(_mm_unpackhi_epi64(low, low)));
    *place = (floats)_mm_movelh_ps(_mm_cvtpd_ps(a), _mm_cvtpd_ps(b));
    return (planes)low;
#else
    planes low;
    for (int i = 0; i < FOUR; i++) {
        double c = four_get(at, i);
        c = fabs(c) < 0x1p31 ? c : -0x1p31;
        int64_t below = plane_below(&c);
        low[i] = (uint32_t)below;
        (*place)[i] = (float)(c - (double)below);
    }
    return low;
#endif
}

/* Whether some plane may be lost: none below 2^30 is. What is no number in 32
 * bits was made -2^31, or what is below that, 2^31 - 1. */
static inline bool planes_lost(planes x, planes y, planes z)
{
    const uint32_t half = 0x40000000;
    planes signs = (x + half) | (y + half) | (z + half);
#ifdef __SSE2__
    return _mm_movemask_ps((__m128)signs) != 0;
#else
    return (signs[0] | signs[1] | signs[2] | signs[3]) >> 31;
#endif
}

/* The coordinate for planes_below on a lattice that begins anew after 2^20
 * planes, or 2^12. Exact: from 2^30 on a double has 22 bits for its fraction.
 */
static inline double plane_wrapped(double at)
{
    if (fabs(at) < 0x1p30)
        return at;
    int64_t low = plane_below(&at);
    return (double)(low & 0xfffff) + (at - (double)low);
}

#endif
