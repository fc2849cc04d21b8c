/* Algebraic surfaces of functions.inc, each where a polynomial is 0. Its first
 * parameter, the field's strength, multiplies the polynomial; beyond 10 the
 * value is 10. */
#include "scene/internal.h"

#include <math.h>

/* a[0..2] are the point, a[3] the strength, what follows is their own. */
#define X a[0]
#define Y a[1]
#define Z a[2]

static double square(double v)
{
    return v * v;
}

static double cube(double v)
{
    return v * v * v;
}

static double limited(double value, double limit)
{
    return value > limit ? limit : value < -limit ? -limit : value;
}

static double field(const double *a, double polynomial)
{
    return limited(a[3] * polynomial, 10);
}

/* ---- in the plane ---- */

struct plane {
    double x, y;
};

/* The point of the plane curve; with `sor` set (the switch, an offset and an
 * angle) it is turned around the y axis. */
static struct plane curve_point(const double *a, const double *sor)
{
    if (!(sor[0] > 0))
        return (struct plane){ X, Y };
    double x = sqrt(X * X + Z * Z) - sor[1];
    double angle = sor[2] * M_PI / 180;
    return (struct plane){ x * cos(angle) - Y * sin(angle),
                           Y * cos(angle) + x * sin(angle) };
}

static double algebraic_cylinder(const double *a, double polynomial)
{
    return limited(a[3] * polynomial, a[4]);
}

static double internal_algbr_cyl1(const double *a)
{
    struct plane p = curve_point(a, a + 5);
    return algebraic_cylinder(a, square(p.y) + square(p.x) * (fabs(p.x) - 1));
}

static double internal_algbr_cyl2(const double *a)
{
    struct plane p = curve_point(a, a + 5);
    double x2 = p.x * p.x, y2 = p.y * p.y;
    return algebraic_cylinder(a, -2 * x2 * x2 + 3 * x2 * p.y -
                                     y2 * square(p.y - 1));
}

static double internal_algbr_cyl3(const double *a)
{
    struct plane p = curve_point(a, a + 5);
    double x2 = p.x * p.x, y2 = p.y * p.y;
    return algebraic_cylinder(a, -x2 * x2 - x2 * y2 + 2 * x2 * p.y + p.x * y2 -
                                     y2);
}

static double internal_algbr_cyl4(const double *a)
{
    struct plane p = curve_point(a, a + 5);
    double x2 = p.x * p.x, y2 = p.y * p.y;
    return algebraic_cylinder(a, -square(x2 + y2) - 3 * x2 * p.y + y2 * p.y);
}

static double internal_devils_curve_2d(const double *a)
{
    struct plane p = curve_point(a, a + 6);
    double x2 = p.x * p.x, y2 = p.y * p.y;
    return field(a, y2 * (y2 - square(a[5])) - x2 * (x2 - square(a[4])));
}

static double internal_folium_surface_2d(const double *a)
{
    struct plane p = curve_point(a, a + 6);
    double x2 = p.x * p.x, y2 = p.y * p.y;
    return field(a, -(y2 * (1 + (a[5] - 4 * a[4]) * p.x) + x2 * (1 + a[5])));
}

static double internal_kampyle_of_eudoxus_2d(const double *a)
{
    struct plane p = curve_point(a, a + 6);
    double x2 = p.x * p.x, c2 = square(a[5]);
    return field(a, c2 * x2 * (x2 - a[4] * a[5]) - square(p.y));
}

static double internal_lemniscate_of_gerono_2d(const double *a)
{
    struct plane p = curve_point(a, a + 6);
    double x2 = p.x * p.x;
    return field(a, square(a[5]) * x2 * (square(a[4]) - x2) - square(p.y));
}

static double internal_piriform_2d(const double *a)
{
    struct plane p = curve_point(a, a + 7);
    return field(a,
                 square(a[6]) * cube(p.x) * (a[4] + a[5] * p.x) - square(p.y));
}

static double internal_strophoid_2d(const double *a)
{
    struct plane p = curve_point(a, a + 7);
    return field(a, square(a[6] * p.x) * (p.x + a[4]) -
                        square(p.y) * (a[5] - p.x));
}

static double internal_witch_of_agnesi_2d(const double *a)
{
    struct plane p = curve_point(a, a + 6);
    return field(a, a[5] - p.y * (square(p.x) + square(a[4])));
}

/* ---- turned around an axis ---- */

static double internal_bicorn(const double *a)
{
    double r2 = X * X + Z * Z, s = a[4];
    return field(a, square(Y) * (s * s - r2) - square(r2 + 2 * s * Y - s * s));
}

static double internal_bifolia(const double *a)
{
    double r2 = X * X + Z * Z;
    return field(a, a[4] * r2 * Y - square(r2 + Y * Y));
}

static double internal_devils_curve(const double *a)
{
    double y2 = Y * Y;
    return field(a, y2 * (y2 - 0.25) + 0.36 * X * X - square(X * X + Z * Z));
}

static double internal_folium_surface(const double *a)
{
    double r2 = Y * Y + Z * Z;
    return field(a, r2 * (1 + (a[5] - 4 * a[4]) * X) + X * X * (1 + a[5]));
}

static double internal_glob(const double *a)
{
    return field(a, 0.5 * square(X * X) * (X + 1) - Y * Y - Z * Z);
}

static double internal_kampyle_of_eudoxus(const double *a)
{
    double x2 = X * X;
    return field(a, square(a[5]) * x2 * (x2 - square(a[4])) - Y * Y - Z * Z);
}

static double internal_lemniscate_of_gerono(const double *a)
{
    return field(a, X * X * (1 - X * X) - Y * Y - Z * Z);
}

static double internal_ovals_of_cassini(const double *a)
{
    double r2 = X * X + Z * Z, s2 = square(a[4]);
    return field(a, a[6] * s2 * r2 + square(a[5]) - square(r2 + Y * Y + s2));
}

static double internal_paraboloid(const double *a)
{
    return field(a, Y - X * X - Z * Z);
}

static double internal_piriform(const double *a)
{
    return field(a, cube(X) * (X - 1) + Y * Y + Z * Z);
}

static double internal_quartic_cylinder(const double *a)
{
    double c2 = square(a[5]);
    return field(a, square(a[4]) * c2 - (X * X + Z * Z) * (Y * Y + c2));
}

static double internal_strophoid(const double *a)
{
    return field(a,
                 square(a[6] * X) * (X + a[4]) - (Y * Y + Z * Z) * (a[5] - X));
}

static double internal_torus2(const double *a)
{
    double r2 = X * X + Z * Z, k = square(a[4]) - square(a[5]);
    return field(a, 4 * square(a[4]) * r2 - square(r2 + Y * Y + k));
}

static double internal_witch_of_agnesi(const double *a)
{
    return field(a, a[4] - Y * (X * X + Z * Z + a[4]));
}

/* ---- others ---- */

/* Apery's polynomial. */
static double internal_boy_surface(const double *a)
{
    const double root = sqrt(2);
    double r2 = X * X + Y * Y, z2 = Z * Z, v = 1 - Z, vz = v * Z;
    double sum = 64 * cube(vz) - 48 * square(vz) * (3 * r2 + 2 * z2) +
                 12 * vz *
                     (27 * r2 * r2 - 24 * z2 * r2 +
                      36 * root * Y * Z * (Y * Y - 3 * X * X) + 4 * z2 * z2) +
                 (9 * r2 - 2 * z2) *
                     (-81 * r2 * r2 - 72 * z2 * r2 +
                      108 * root * X * Z * (X * X - 3 * Y * Y) + 4 * z2 * z2);
    return field(a, a[4] * sum);
}

static double internal_crossed_trough(const double *a)
{
    return field(a, X * X * Z * Z - Y);
}

static double internal_cubic_saddle(const double *a)
{
    return field(a, cube(Y) - cube(X) + Z);
}

/* Both f_cushion and f_odd (measured). */
static double internal_cushion(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, x2 * (z2 + 1 - x2 - 2 * y2) + y2 * (1 - y2 - z2 + 2 * Z) -
                        z2 * (z2 - 2 * Z + 2));
}

/* A torus around y, moved, and inverted in a sphere; but for the last term,
 * which was measured. */
static double internal_dupin_cyclid(const double *a)
{
    double major = a[4], minor = a[5], dx = a[6], dy = a[7], k2 = square(a[8]);
    double s = X * X + Y * Y + Z * Z;
    double squares = major * major - minor * minor;
    double all = k2 * k2 - 2 * k2 * (X * dx + Y * dy) +
                 s * (dx * dx + dy * dy + squares);
    return field(a, 4 * square(major) *
                            (square(k2 * X - dx * s) + square(k2 * Z)) -
                        square(all) - 8 * k2 * dy * s * Y * squares);
}

/* Not quite Enneper's surface, but what POV-Ray has in its place. */
static double internal_enneper(const double *a)
{
    double saddle = (Y * Y - X * X) / (fabs(Z) < 0.2 ? 0.2 : Z);
    return field(a, 6 * square(saddle / 4) - cube(saddle / 2 + 2 * Z * Z / 9));
}

static double internal_heart(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a,
                 0.1 * x2 * z2 * Z + y2 * z2 * Z - cube(2 * x2 + y2 + z2 - 1));
}

static double internal_hunt_surface(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, -4 * cube(x2 + y2 + z2 - 13) -
                        27 * square(3 * x2 + y2 - 4 * z2 - 12));
}

static double internal_hyperbolic_torus(const double *a)
{
    double r2 = X * X - Z * Z, k = square(a[4]) - square(a[5]);
    return field(a, 4 * square(a[4]) * r2 - square(r2 + Y * Y + k));
}

static double internal_klein_bottle(const double *a)
{
    double s = X * X + Y * Y + Z * Z, w = s - 2 * Y - 1;
    return field(a,
                 -(s + 2 * Y - 1) * (square(w) - 8 * Z * Z) - 16 * X * Z * w);
}

static double internal_kummer_surface_v1(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, x2 + y2 + z2 + x2 * y2 + x2 * z2 + y2 * z2 - 1 - x2 * x2 -
                        y2 * y2 - z2 * z2);
}

static double internal_kummer_surface_v2(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, 1 - a[4] * (x2 + y2 + z2) -
                        a[5] * (x2 * y2 + x2 * z2 + y2 * z2) -
                        a[6] * X * Y * Z - x2 * x2 - y2 * y2 - z2 * z2);
}

static double internal_mitre(const double *a)
{
    double x2 = X * X, y2 = Y * Y, s = x2 + y2 + Z * Z;
    return field(a, y2 * (1 - y2 - Z * Z) - 4 * x2 * s);
}

static double internal_nodal_cubic(const double *a)
{
    return field(a, 6 * Y * Z - cube(Y) - cube(Z));
}

static double internal_parabolic_torus(const double *a)
{
    double r2 = X * X - Z, y2 = Y * Y, k = square(a[4]) - square(a[5]);
    return field(a, (2 * square(a[4]) - k) * r2 - k * y2 - k * k -
                        square(r2 + y2));
}

static double internal_pillow(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, x2 * (x2 - 1) + y2 * (y2 - 1) + z2 * (z2 - 1));
}

static double internal_quartic_paraboloid(const double *a)
{
    return field(a, Y - square(X * X) - square(Z * Z));
}

static double internal_quartic_saddle(const double *a)
{
    return field(a, Y - square(X * X) + square(Z * Z));
}

static double internal_steiners_roman(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, -(x2 * y2 + x2 * z2 + y2 * z2 + X * Y * Z));
}

static double internal_torus_gumdrop(const double *a)
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    return field(a, 20 * (x2 + y2 + z2) - 4 * (x2 * x2 + square(y2 + z2)) -
                        17 * x2 * (y2 + z2) - 17);
}

static double internal_umbrella(const double *a)
{
    return field(a, Y * Z * Z - X * X);
}

const struct internal_function internal_algebraic[] = {
    { 0, 8, internal_algbr_cyl1 },
    { 1, 8, internal_algbr_cyl2 },
    { 2, 8, internal_algbr_cyl3 },
    { 3, 8, internal_algbr_cyl4 },
    { 4, 5, internal_bicorn },
    { 5, 5, internal_bifolia },
    { 8, 5, internal_boy_surface },
    { 11, 4, internal_crossed_trough },
    { 12, 4, internal_cubic_saddle },
    { 13, 4, internal_cushion },
    { 14, 4, internal_devils_curve },
    { 15, 9, internal_devils_curve_2d },
    { 16, 9, internal_dupin_cyclid },
    { 18, 4, internal_enneper },
    { 20, 6, internal_folium_surface },
    { 21, 9, internal_folium_surface_2d },
    { 22, 4, internal_glob },
    { 23, 4, internal_heart },
    { 30, 4, internal_hunt_surface },
    { 31, 6, internal_hyperbolic_torus },
    { 33, 6, internal_kampyle_of_eudoxus },
    { 34, 9, internal_kampyle_of_eudoxus_2d },
    { 35, 4, internal_klein_bottle },
    { 36, 4, internal_kummer_surface_v1 },
    { 37, 7, internal_kummer_surface_v2 },
    { 38, 4, internal_lemniscate_of_gerono },
    { 39, 9, internal_lemniscate_of_gerono_2d },
    { 41, 4, internal_mitre },
    { 42, 4, internal_nodal_cubic },
    { 43, 4, internal_cushion },
    { 44, 7, internal_ovals_of_cassini },
    { 45, 4, internal_paraboloid },
    { 46, 6, internal_parabolic_torus },
    { 48, 4, internal_pillow },
    { 49, 4, internal_piriform },
    { 50, 10, internal_piriform_2d },
    { 54, 4, internal_quartic_paraboloid },
    { 55, 4, internal_quartic_saddle },
    { 56, 6, internal_quartic_cylinder },
    { 65, 4, internal_steiners_roman },
    { 66, 7, internal_strophoid },
    { 67, 10, internal_strophoid_2d },
    { 71, 6, internal_torus2 },
    { 72, 4, internal_torus_gumdrop },
    { 73, 4, internal_umbrella },
    { 74, 5, internal_witch_of_agnesi },
    { 75, 9, internal_witch_of_agnesi_2d },
    { 0, 0, 0 },
};
