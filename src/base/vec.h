/* Three-component vectors in double precision, by value. POV-Ray's frame is
 * left-handed: x right, y up, z into the picture. */
#ifndef BASE_VEC_H
#define BASE_VEC_H

#include <math.h>
#include <stdbool.h>

#include "base/lesser.h"

typedef struct {
    double x, y, z;
} vec3;

static inline vec3 vec3_make(double x, double y, double z)
{
    return (vec3){ x, y, z };
}

static inline vec3 vec3_add(vec3 a, vec3 b)
{
    return (vec3){ a.x + b.x, a.y + b.y, a.z + b.z };
}

static inline vec3 vec3_sub(vec3 a, vec3 b)
{
    return (vec3){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static inline vec3 vec3_mul(vec3 a, vec3 b)
{
    return (vec3){ a.x * b.x, a.y * b.y, a.z * b.z };
}

static inline vec3 vec3_scale(vec3 a, double s)
{
    return (vec3){ a.x * s, a.y * s, a.z * s };
}

static inline vec3 vec3_negate(vec3 a)
{
    return (vec3){ -a.x, -a.y, -a.z };
}

/* a + s b: the point at parameter s of the ray (a, b). */
static inline vec3 vec3_along(vec3 a, vec3 b, double s)
{
    return (vec3){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}

/* As far from `middle` as `a`, on its other side. */
static inline vec3 vec3_opposite(vec3 a, vec3 middle)
{
    return (vec3){ 2 * middle.x - a.x, 2 * middle.y - a.y, 2 * middle.z - a.z };
}

static inline vec3 vec3_mix(vec3 a, vec3 b, double t)
{
    return vec3_along(a, vec3_sub(b, a), t);
}

/* To the last bit. */
static inline bool vec3_same(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static inline double vec3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 vec3_cross(vec3 a, vec3 b)
{
    return (vec3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                   a.x * b.y - a.y * b.x };
}

static inline double vec3_length(vec3 a)
{
    return sqrt(vec3_dot(a, a));
}

/* The unit vector along a; a zero vector stays zero. */
static inline vec3 vec3_normalise(vec3 a)
{
    double length = vec3_length(a);
    return length > 0 ? vec3_scale(a, 1 / length) : a;
}

/* The normal or its opposite: the one that does not go along the direction. */
static inline vec3 vec3_against(vec3 normal, vec3 direction)
{
    return vec3_dot(normal, direction) > 0 ? vec3_negate(normal) : normal;
}

/* Of what in `b` is no number that of `a` is taken. */
static inline vec3 vec3_min(vec3 a, vec3 b)
{
    return (vec3){ lesser(b.x, a.x), lesser(b.y, a.y), lesser(b.z, a.z) };
}

static inline vec3 vec3_max(vec3 a, vec3 b)
{
    return (vec3){ greater(b.x, a.x), greater(b.y, a.y), greater(b.z, a.z) };
}

static inline bool vec3_finite(vec3 a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

/* Component 0, 1 or 2. */
static inline double vec3_component(vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

#endif
