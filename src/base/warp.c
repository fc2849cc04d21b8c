/* Directions and discs: see warp.h. */
#include "base/warp.h"

/* Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017. */
void warp_frame(vec3 n, vec3 *a, vec3 *b)
{
    double sign = copysign(1, n.z);
    double s = -1 / (sign + n.z), t = n.x * n.y * s;
    *a = vec3_make(1 + sign * n.x * n.x * s, sign * t, -sign * n.x);
    *b = vec3_make(t, sign + n.y * n.y * s, -n.y);
}

void warp_disc(const double u[2], double *x, double *y)
{
    double a = 2 * u[0] - 1, b = 2 * u[1] - 1;
    bool wide = fabs(a) > fabs(b);
    double r = wide ? a : b, angle = 0;
    if (wide)
        angle = WARP_PI / 4 * (b / a);
    else if (b != 0)
        angle = WARP_PI / 2 - WARP_PI / 4 * (a / b);
    *x = r * cos(angle);
    *y = r * sin(angle);
}

/* The direction at `cosine` from the axis, whose sine is given because it may
 * be known better. */
static vec3 warp_around(vec3 axis, double cosine, double sine, double turn)
{
    vec3 a, b;
    warp_frame(axis, &a, &b);
    double angle = 2 * WARP_PI * turn;
    vec3 v = vec3_scale(axis, cosine);
    v = vec3_along(v, a, sine * cos(angle));
    return vec3_normalise(vec3_along(v, b, sine * sin(angle)));
}

/* Lambert's is the disc lifted to the hemisphere (Malley), which keeps the
 * samples as even as the disc's. */
vec3 warp_lambert(const double u[2])
{
    double x, y;
    warp_disc(u, &x, &y);
    return vec3_make(x, y, sqrt(fmax(0, 1 - x * x - y * y)));
}

vec3 warp_turned(vec3 way, vec3 axis)
{
    vec3 a, b;
    warp_frame(axis, &a, &b);
    vec3 v = vec3_along(vec3_scale(axis, way.z), a, way.x);
    return vec3_normalise(vec3_along(v, b, way.y));
}

vec3 warp_lobe(const double u[2], vec3 axis, double m)
{
    if (m == 1)
        return warp_turned(warp_lambert(u), axis);
    double cosine = pow(1 - u[0], 1 / (m + 1));
    return warp_around(axis, cosine, sqrt(fmax(0, 1 - cosine * cosine)), u[1]);
}

double warp_lobe_density(double cosine, double m)
{
    if (!(cosine > 0))
        return 0;
    return (m + 1) / (2 * WARP_PI) * (m == 1 ? cosine : pow(cosine, m));
}

vec3 warp_cone(const double u[2], vec3 axis, double rise)
{
    double x, y;
    warp_disc(u, &x, &y);
    double down = (x * x + y * y) * rise; /* 1 - cosine */
    double wide = sqrt(fmax(0, rise * (2 - down)));
    return warp_turned(vec3_make(x * wide, y * wide, 1 - down), axis);
}

double warp_cone_density(double rise)
{
    return 1 / (2 * WARP_PI * rise);
}

vec3 warp_sphere(const double u[2])
{
    double down = 2 * u[0]; /* 1 - cosine */
    return warp_around(vec3_make(0, 0, 1), 1 - down,
                       sqrt(fmax(0, down * (2 - down))), u[1]);
}
