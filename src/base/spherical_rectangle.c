/* See spherical_rectangle.h. */
#include "base/spherical_rectangle.h"

#include <math.h>

#include "base/warp.h"

static double cosine_angle(double cosine)
{
    return acos(fmin(fmax(cosine, -1), 1));
}

/* The z of the unit normal of the plane through the point and a side that is so
 * far off. */
static double side_normal(double side, double z0)
{
    return side / sqrt(side * side + z0 * z0);
}

/* The angles between the planes, as the great circles that bound what is seen
 * meet at its corners. */
static void rectangle_angles(struct spherical_rectangle *seen)
{
    const double z0 = seen->z0;
    const double low_y = side_normal(seen->y0, z0),
                 high_y = side_normal(seen->y1, z0),
                 low_x = side_normal(seen->x0, z0),
                 high_x = side_normal(seen->x1, z0);
    const double n0 = -low_y, n1 = high_x, n2 = high_y, n3 = -low_x;
    const double g0 = cosine_angle(-n0 * n1), g1 = cosine_angle(-n1 * n2),
                 g2 = cosine_angle(-n2 * n3), g3 = cosine_angle(-n3 * n0);
    seen->b0 = n0;
    seen->b1 = n2;
    seen->k = 2 * WARP_PI - g2 - g3;
    seen->angle = fmax(g0 + g1 - seen->k, 0);
}

struct spherical_rectangle spherical_rectangle_new(vec3 at, vec3 a, vec3 b,
                                                   vec3 from)
{
    const double wide = vec3_length(a), high = vec3_length(b);
    const vec3 corner = vec3_sub(at, from);
    struct spherical_rectangle seen = { .from = from,
                                        .x = vec3_scale(a, 1 / wide),
                                        .y = vec3_scale(b, 1 / high) };
    seen.z = vec3_cross(seen.x, seen.y);
    seen.z0 = vec3_dot(corner, seen.z);
    if (seen.z0 > 0) {
        seen.z = vec3_negate(seen.z);
        seen.z0 = -seen.z0;
    }
    seen.x0 = vec3_dot(corner, seen.x);
    seen.y0 = vec3_dot(corner, seen.y);
    seen.x1 = seen.x0 + wide;
    seen.y1 = seen.y0 + high;
    if (seen.z0 < 0 && wide > 0 && high > 0)
        rectangle_angles(&seen);
    return seen;
}

vec3 spherical_rectangle_point(const struct spherical_rectangle *seen,
                               const double u[2])
{
    const double turn = u[0] * seen->angle + seen->k;
    const double f = (cos(turn) * seen->b0 - seen->b1) / sin(turn);
    const double c = copysign(1 / sqrt(f * f + seen->b0 * seen->b0), f);
    const double cosine = fmin(fmax(c, -1), 1);
    double x = -cosine * seen->z0 / sqrt(fmax(1 - cosine * cosine, 1e-300));
    x = fmin(fmax(x, seen->x0), seen->x1);
    const double far2 = x * x + seen->z0 * seen->z0;
    const double h0 = seen->y0 / sqrt(far2 + seen->y0 * seen->y0),
                 h1 = seen->y1 / sqrt(far2 + seen->y1 * seen->y1);
    const double h = h0 + u[1] * (h1 - h0), left = 1 - h * h;
    double y = left > 0 ? h * sqrt(far2 / left) : seen->y1;
    y = fmin(fmax(y, seen->y0), seen->y1);
    vec3 place = vec3_along(seen->from, seen->x, x);
    place = vec3_along(place, seen->y, y);
    return vec3_along(place, seen->z, seen->z0);
}
