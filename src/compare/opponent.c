/* YCxCz and CIE L*a*b* of section 4.1 of the FLIP paper (see flip.c). XYZ here
 * is divided by that of white, so that white is 1, 1, 1. The matrices follow
 * from the chromaticities of sRGB's primaries and white (IEC 61966-2-1: 0.64
 * 0.33, 0.30 0.60, 0.15 0.06, 0.3127 0.3290) and are each other's inverse. */
#include "compare/opponent.h"

#include <math.h>

struct opponent_matrix {
    vec3 row[3];
};

static const struct opponent_matrix to_xyz = { {
    { 0.4338873455660399, 0.3762240091374987, 0.1898886452964614 },
    { 0.2126390058715104, 0.7151686787677560, 0.0721923153607337 },
    { 0.0177500400709733, 0.1094476208552385, 0.8728023390737882 },
} };
static const struct opponent_matrix from_xyz = { {
    { 3.0803990906794638, -1.5373831775700928, -0.5430159131093708 },
    { -0.9212233588602765, 1.8759675015077195, 0.0452558573525563 },
    { 0.0528739389703644, -0.2039769588889765, 1.1511030199186116 },
} };

static vec3 opponent_multiply(const struct opponent_matrix *m, vec3 v)
{
    return vec3_make(vec3_dot(m->row[0], v), vec3_dot(m->row[1], v),
                     vec3_dot(m->row[2], v));
}

vec3 opponent_from_light(vec3 light)
{
    vec3 v = opponent_multiply(&to_xyz, light);
    return vec3_make(116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z));
}

static double opponent_cut(double v)
{
    return fmin(fmax(v, 0), 1);
}

vec3 opponent_to_light(vec3 opponent)
{
    double y = (opponent.x + 16) / 116;
    vec3 xyz = { y + opponent.y / 500, y, y - opponent.z / 200 };
    vec3 light = opponent_multiply(&from_xyz, xyz);
    return vec3_make(opponent_cut(light.x), opponent_cut(light.y),
                     opponent_cut(light.z));
}

/* The cube root of CIE 1976, straight below (6/29)^3. */
static double opponent_root(double v)
{
    const double foot = 6.0 / 29;
    if (v > foot * foot * foot)
        return cbrt(v);
    return v / (3 * foot * foot) + 4.0 / 29;
}

vec3 opponent_lab(vec3 light)
{
    vec3 v = opponent_multiply(&to_xyz, light);
    double x = opponent_root(v.x), y = opponent_root(v.y);
    double z = opponent_root(v.z);
    double lightness = 116 * y - 16;
    double hunt = 0.01 * lightness;
    return vec3_make(lightness, hunt * 500 * (x - y), hunt * 200 * (y - z));
}
