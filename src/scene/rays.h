/* Rays side by side, coordinate by coordinate, so that one instruction works on
 * several of them. Those of a packet begin and go close together. */
#ifndef SCENE_RAYS_H
#define SCENE_RAYS_H

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "base/affine.h"
#include "base/clones.h"
#include "scene/ray.h"

enum { RAY_LANES = 16 };

/* What is in lanes that are not asked about doesn't matter. */
struct rays {
    LANE_LINES double origin[3][RAY_LANES], direction[3][RAY_LANES];
};

/* The part of each ray that counts; of a ray that doesn't take part there is
 * none: `far` is -INFINITY. */
struct rays_span {
    LANE_LINES double near[RAY_LANES], far[RAY_LANES];
};

/* Where each of them first meets a shape: INFINITY if it doesn't. */
struct rays_met {
    LANE_LINES double t[RAY_LANES];
    double part[RAY_LANES]; /* as of a hit; v of shapes met so is 0 */
    double u[RAY_LANES];    /* the same; 0, unless the shape says */
};

/* Takes a crossing of each of the rays that the bits `met` stand for, which has
 * no u and v, and is of part 0; returns those that want no more. */
typedef unsigned rays_visit(void *context, unsigned met,
                            const double t[RAY_LANES]);

/* All crossings of each, in the order that its shape's intersect tells them,
 * but for gaps where t is INFINITY. u and v are 0. */
enum { RAY_CROSSINGS = 4 };

struct rays_crossings {
    int count; /* of rows */
    LANE_LINES double t[RAY_CROSSINGS][RAY_LANES],
        part[RAY_CROSSINGS][RAY_LANES];
};

/* Lanes from `first` on, before `end`: those that are worked out, whatever is
 * in the others. Where its vectors are of eight floats Embree follows each half
 * of a packet by itself. */
enum { LANE_STEP = 8 };

struct lane_run {
    int first, end; /* multiples of LANE_STEP */
};

/* The shortest that has all that the bits `lanes` stand for. */
static inline struct lane_run lane_run_of(unsigned lanes)
{
    const unsigned low = (1u << LANE_STEP) - 1;
    return (struct lane_run){ lanes & low ? 0 : LANE_STEP,
                              lanes & ~low ? RAY_LANES : LANE_STEP };
}

static inline struct lane_run lane_run_all(void)
{
    return (struct lane_run){ 0, RAY_LANES };
}

static inline unsigned lane_run_bits(struct lane_run run)
{
    return (1u << run.end) - (1u << run.first);
}

/* A loop over them. The compiler sees between which lanes they are, without
 * which it wouldn't make wide instructions of it: tests/tools/check-lanes
 * looks. (Of a loop over steps in which is one over lanes gcc 12 makes wrong
 * code.) */
#define EACH_LANE(i, run)                                                      \
    for (int i = (run).first ? LANE_STEP : 0,                                  \
             i##_end = (run).end > LANE_STEP ? RAY_LANES : LANE_STEP;          \
         i < i##_end; i++)

/* A point for each lane. */
struct lane_points {
    LANE_LINES double at[3][RAY_LANES];
};

/* The vector in a lane. */
static inline vec3 lane_get(const double (*from)[RAY_LANES], unsigned i)
{
    return (vec3){ from[0][i], from[1][i], from[2][i] };
}

static inline void lane_put(double (*to)[RAY_LANES], unsigned i, vec3 v)
{
    to[0][i] = v.x;
    to[1][i] = v.y;
    to[2][i] = v.z;
}

static inline vec3 rays_origin(const struct rays *rays, int i)
{
    return lane_get(rays->origin, (unsigned)i);
}

static inline vec3 rays_direction(const struct rays *rays, int i)
{
    return lane_get(rays->direction, (unsigned)i);
}

static inline void rays_set(struct rays *rays, int i, vec3 origin,
                            vec3 direction)
{
    lane_put(rays->origin, (unsigned)i, origin);
    lane_put(rays->direction, (unsigned)i, direction);
}

static inline struct ray rays_at(const struct rays *rays, int i)
{
    return (struct ray){ rays_origin(rays, i), rays_direction(rays, i) };
}

/* Only the first `count` are set: the others become the first, if there is one,
 * and meet nothing. What packets look at is decided by all lanes, though only
 * those that are asked for are told: chance ones made 300 balls of a blob .2
 * dearer. */
static inline void rays_fill(struct rays *rays, struct rays_span *span,
                             unsigned count)
{
    if (count == 0)
        return;
    const struct ray first = rays_at(rays, 0);
    for (unsigned i = count; i < RAY_LANES; i++) {
        rays_set(rays, (int)i, first.origin, first.direction);
        span->near[i] = 0;
        span->far[i] = -1;
    }
}

/* All of them in another space, as ray_into takes one there. */
void rays_into(const affine *transform, struct lane_run run,
               const struct rays *rays, struct rays *out);

/* Points side by side in another space. */
void lane_points_into(const affine *transform, struct lane_run run,
                      const struct lane_points *points,
                      struct lane_points *out);

/* Of all crossings the first of each ray between near and far, and whether
 * there is any. */
void rays_first_of(const struct rays_crossings *all, struct lane_run run,
                   const struct rays_span *span, struct rays_met *met);
void rays_crosses_of(const struct rays_crossings *all, struct lane_run run,
                     const struct rays_span *span, lane_flag *met);

/* Which of them meet it at all. */
void rays_crosses_met(const struct rays_met *first, struct lane_run run,
                      lane_flag *met);

/* The span, or, if that would be work for a shape that looks at rays one by
 * one, in *out that without the rays that are not asked about. */
const struct rays_span *rays_span_asked(const struct rays_span *span,
                                        unsigned lanes, bool lane_by_lane,
                                        struct rays_span *out);

/* Bit by bit what n flags say, of which all bits are set or none. */
static inline unsigned flags_bits(const int32_t *flags, unsigned n)
{
    unsigned bits = 0, i = 0;
#ifdef __SSE2__
    for (; i + 4 <= n; i += 4)
        bits |= (unsigned)_mm_movemask_ps(
                    _mm_loadu_ps((const float *)(const void *)(flags + i)))
                << i;
#endif
    for (; i < n; i++)
        bits |= (unsigned)(flags[i] & 1) << i;
    return bits;
}

/* Bit by bit what the flags of all lanes say. */
static inline unsigned rays_bits(const lane_flag flags[RAY_LANES])
{
#ifdef __SSE2__
    /* Lanes become bytes, whose sign bits are gathered at once. */
    const __m128 *at = (const __m128 *)flags;
    __m128i part[4];
    for (int i = 0; i < 4; i++)
        part[i] = _mm_castps_si128(
            _mm_shuffle_ps(_mm_loadu_ps((const float *)(at + 2 * i)),
                           _mm_loadu_ps((const float *)(at + 2 * i + 1)),
                           _MM_SHUFFLE(2, 0, 2, 0)));
    __m128i low = _mm_packs_epi32(part[0], part[1]);
    __m128i high = _mm_packs_epi32(part[2], part[3]);
    return (unsigned)_mm_movemask_epi8(_mm_packs_epi16(low, high));
#else
    unsigned bits = 0;
    for (int i = 0; i < RAY_LANES; i++)
        bits |= (unsigned)flags[i] & 1u << i;
    return bits;
#endif
}

#endif
