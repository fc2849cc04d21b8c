/* Other shapes of functions.inc: distances, waves, bells. */
#include "scene/internal.h"

#include <math.h>

#define X a[0]
#define Y a[1]
#define Z a[2]

static double square(double v)
{
    return v * v;
}

static double internal_r(const double *a)
{
    return sqrt(X * X + Y * Y + Z * Z);
}

static double internal_sphere(const double *a)
{
    return internal_r(a) - a[3];
}

static double internal_theta(const double *a)
{
    return atan2(X, Z);
}

static double internal_phi(const double *a)
{
    return atan2(sqrt(X * X + Z * Z), Y);
}

static double internal_ellipsoid(const double *a)
{
    return sqrt(square(X * a[3]) + square(Y * a[4]) + square(Z * a[5]));
}

/* How far outside of the box that is smaller by the radius of its edges, less
 * that radius. */
static double internal_rounded_box(const double *a)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double side = fabs(a[i]) - (a[4 + i] - a[3]);
        sum += side > 0 ? side * side : 0;
    }
    return sqrt(sum) - a[3] - 1e-6; /* measured */
}

static double internal_torus(const double *a)
{
    double ring = sqrt(X * X + Z * Z) - a[3];
    return sqrt(ring * ring + Y * Y) - a[4];
}

static double internal_superellipsoid(const double *a)
{
    double east = 2 / a[3], north = 2 / a[4];
    double round = pow(fabs(X), east) + pow(fabs(Y), east);
    double norm = pow(round, a[3] / a[4]) + pow(fabs(Z), north);
    return 1 - pow(norm, a[4] / 2);
}

/* ---- bells ---- */

/* (1 - r^2 / R^2)^2 within R, which is given as 1 / R. */
static double blob_density(const double *a, double x, double inverse)
{
    double share = 1 - (square(X - x) + Y * Y + Z * Z) * inverse * inverse;
    return share > 0 ? share * share : 0;
}

static double internal_blob(const double *a)
{
    return -a[4] * blob_density(a, -a[3] / 2, a[5]) -
           a[6] * blob_density(a, a[3] / 2, a[7]);
}

static double internal_blob2(const double *a)
{
    double rest = Y * Y + Z * Z;
    return a[6] - a[5] * (exp(-a[4] * (X * X + rest)) +
                          exp(-a[4] * (square(X - a[3]) + rest)));
}

/* Squared distances, all axes but one shrunk by the eccentricity. */
static void ellipsoids(const double *a, double eccentricity, double squares[3])
{
    double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
    squares[0] = x2 + eccentricity * (y2 + z2);
    squares[1] = y2 + eccentricity * (x2 + z2);
    squares[2] = z2 + eccentricity * (x2 + y2);
}

static double internal_cross_ellipsoids(const double *a)
{
    double s[3];
    ellipsoids(a, a[3], s);
    return a[6] - a[5] * exp(-a[4] * fmin(s[0], fmin(s[1], s[2])));
}

static double internal_isect_ellipsoids(const double *a)
{
    double s[3];
    ellipsoids(a, a[3], s);
    return a[6] - a[5] * exp(-a[4] * fmax(s[0], fmax(s[1], s[2])));
}

static double ellipsoids_sum(const double *a, double eccentricity,
                             double sharpness)
{
    double s[3];
    ellipsoids(a, eccentricity, s);
    return exp(-sharpness * s[0]) + exp(-sharpness * s[1]) +
           exp(-sharpness * s[2]);
}

static double internal_flange_cover(const double *a)
{
    return a[6] - a[5] * ellipsoids_sum(a, a[3], a[4]);
}

static double internal_spikes(const double *a)
{
    double r2 = X * X + Y * Y + Z * Z;
    return a[5] * (ellipsoids_sum(a, a[3], a[4]) - a[7] * exp(-a[6] * r2));
}

/* ---- patterns of a plane ---- */

/* Where the point is in its cell of a tiling by hexagons of side 1, two sides
 * along y: as far as towards the nearest side, and along it. */
static void hexagon_place(const double *a, double *outward, double *along)
{
    const double width = sqrt(3);
    double best = HUGE_VAL, x = 0, y = 0;
    for (int row = 0; row < 2; row++) {
        double dx = X - row * width / 2, dy = Y - row * 1.5;
        dx -= width * round(dx / width);
        dy -= 3 * round(dy / 3);
        if (dx * dx + dy * dy < best) {
            best = dx * dx + dy * dy;
            x = fabs(dx);
            y = fabs(dy);
        }
    }
    double slanted = x / 2 + y * width / 2;
    *outward = fmax(x, slanted);
    *along = x > slanted ? y : fabs(y / 2 - x * width / 2);
}

static double internal_hex_x(const double *a)
{
    double outward, along;
    hexagon_place(a, &outward, &along);
    return outward;
}

static double internal_hex_y(const double *a)
{
    double outward, along;
    hexagon_place(a, &outward, &along);
    return along;
}

/* From the nearest of the threads at every other multiple, all at one height.
 */
static double mesh_threads(double across, double apart, double first,
                           double height, const double *a)
{
    double off = across - apart * first;
    off -= 2 * apart * round(off / (2 * apart));
    return sqrt(square(off * a[5]) + square((Y - height) * a[7]));
}

/* Woven threads: along x at each multiple of a[4], along z of a[3]. */
static double internal_mesh1(const double *a)
{
    double wave_x = a[6] * cos(M_PI * X / a[3]);
    double wave_z = a[6] * cos(M_PI * Z / a[4]);
    return fmin(fmin(mesh_threads(Z, a[4], 0, wave_x, a),
                     mesh_threads(Z, a[4], 1, -wave_x, a)),
                fmin(mesh_threads(X, a[3], 0, -wave_z, a),
                     mesh_threads(X, a[3], 1, wave_z, a)));
}

static double internal_spikes_2d(const double *a)
{
    return Y -
           a[3] * cos(a[4] * X) * cos(a[5] * Z) * exp(-a[6] * (X * X + Z * Z));
}

/* ---- tubes ---- */

/* From the middle of a tube's cross-section, of type 1 round, of 0 square,
 * between them with round corners. */
static double tube_norm(double u, double v, double type)
{
    u = fabs(u);
    v = fabs(v);
    if (type == 0)
        return fmax(u, v);
    if (type == 1)
        return sqrt(u * u + v * v);
    return pow(pow(u, 2 / type) + pow(v, 2 / type), type / 2);
}

static double tube_turned(double u, double v, double degrees, double type)
{
    double c = cos(degrees * M_PI / 180), s = sin(degrees * M_PI / 180);
    return tube_norm(u * c - v * s, u * s + v * c, type);
}

/* Helixes around y, measured along y and away from it. */
static double internal_helix1(const double *a)
{
    double apart = 2 * M_PI / (a[3] * a[4]);
    double turns = (Y + atan2(Z, X) / a[4]) / apart;
    double along = (turns - floor(turns) - 0.5) * apart;
    double out = sqrt(X * X + Z * Z) - a[6];
    return tube_turned(out, along / a[7], a[9], a[8]) - a[5];
}

/* One, measured across y, which its angle has no effect on (measured). */
static double internal_helix2(const double *a)
{
    double turn = a[4] * Y, c = cos(turn), s = sin(turn);
    return tube_norm(X * c + Z * s - a[6], Z * c - X * s, a[8]) - a[5];
}

/* A torus of radius a[3] with windings around it, each with grooves, as far out
 * as a[8]; where the windings leave room one sees the torus, and about its axis
 * a column. Each as far from it, all but the column thicker by the winding's
 * thickness at that angle. */
static double internal_helical_torus(const double *a)
{
    double radius = sqrt(X * X + Z * Z), turn = atan2(X, Z);
    double from = hypot(radius - a[3], Y), out = from - a[8];
    double winding = a[4] * turn + a[5] * atan2(radius - a[3], Y);
    double across = winding - 2 * M_PI * floor(winding / (2 * M_PI)) - M_PI;
    double groove = a[10] * atan2(across * a[11], out) + a[12] * turn;
    double tubes = sqrt(out * out + a[9] * across * across);
    double column = radius + a[3] - a[8], thick = a[6] * cos(groove);
    return fmin(column, fmin(tubes, from + a[8]) - thick) - a[7];
}

/* Windings in the plane of x and z, each a[3] farther out, cut by a ball. */
static double internal_spiral(const double *a)
{
    double radius = sqrt(X * X + Z * Z);
    double turn = 0.5 + atan2(-Z, X) / (2 * M_PI);
    double winding = radius / a[3] - turn;
    double across = (winding - round(winding)) * a[3];
    return fmax(tube_norm(across, Y, a[8]) - a[4], internal_r(a) - a[5]);
}

static double powers(const double *c, double y)
{
    return c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4])));
}

/* No radius is less than -5 (measured). */
static double internal_poly4(const double *a)
{
    return sqrt(X * X + Z * Z) - fmax(powers(a + 3, Y), -5);
}

/* From the nearest of so many lines around y, as far from it as the polynomial
 * says; on the other side of it if that is negative. */
static double internal_polytubes(const double *a)
{
    double apart = 2 * M_PI / a[3], radius = sqrt(X * X + Z * Z);
    double away = powers(a + 4, Y);
    double turn = atan2(X, Z) + (away < 0 ? M_PI : 0);
    turn -= apart * round(turn / apart);
    return hypot(radius * cos(turn) - fabs(away), radius * sin(turn));
}

/* ---- others ---- */

/* Half of yin and yang: a ball, and a tail that is bent around the place of
 * the other one and grows thin. */
static double internal_comma(const double *a)
{
    double size = a[3], x = X == 0 && Z == 0 ? 1e-4 : X;
    double ball = sqrt(square(x - size / 2) + Y * Y + Z * Z) - size / 2;
    double ring = hypot(x + size / 4, Z) - 0.75 * size;
    double thick = size / 2 * fabs(cos(atan2(Z, x) / 2));
    return fmin(fmax(hypot(ring, Y) - thick, -Z), ball);
}

/* An electron's orbital, 3d with m = 0, around y. */
static double internal_quantum(const double *a)
{
    double r2 = X * X + Y * Y + Z * Z;
    return 1.2 - 1.6 * square(3 * Y * Y - r2) * exp(-4.0 / 3 * sqrt(r2));
}

const struct internal_function internal_shapes[] = {
    { 6, 8, internal_blob },
    { 7, 7, internal_blob2 },
    { 9, 4, internal_comma },
    { 10, 7, internal_cross_ellipsoids },
    { 17, 6, internal_ellipsoid },
    { 19, 7, internal_flange_cover },
    { 24, 13, internal_helical_torus },
    { 25, 10, internal_helix1 },
    { 26, 10, internal_helix2 },
    { 27, 4, internal_hex_x },
    { 28, 4, internal_hex_y },
    { 32, 7, internal_isect_ellipsoids },
    { 40, 8, internal_mesh1 },
    { 47, 3, internal_phi },
    { 51, 8, internal_poly4 },
    { 52, 9, internal_polytubes },
    { 53, 4, internal_quantum },
    { 57, 3, internal_r },
    { 60, 7, internal_rounded_box },
    { 61, 4, internal_sphere },
    { 62, 8, internal_spikes },
    { 63, 7, internal_spikes_2d },
    { 64, 9, internal_spiral },
    { 68, 5, internal_superellipsoid },
    { 69, 3, internal_theta },
    { 70, 5, internal_torus },
    { 0, 0, 0 },
};
