/* The unit square mapped to directions and discs, with the densities that the
 * maps have. Densities are per solid angle; axes are unit. */
#ifndef BASE_WARP_H
#define BASE_WARP_H

#include "base/vec.h"

#define WARP_PI 3.14159265358979323846

/* Two unit vectors that make a right-handed frame with the unit vector n. */
void warp_frame(vec3 n, vec3 *a, vec3 *b);

/* Uniform on the unit disc (Shirley and Chiu, 1997: squares to rings). */
void warp_disc(const double u[2], double *x, double *y);

/* Around `axis` with density (m + 1)/(2 pi) cos^m, m >= 0; m = 1 is Lambert. */
vec3 warp_lobe(const double u[2], vec3 axis, double m);
/* Lambert's in two steps, for many places that look in the same directions:
 * around z, and then with z turned to the axis. */
vec3 warp_lambert(const double u[2]);
vec3 warp_turned(vec3 way, vec3 axis);

double warp_lobe_density(double cosine, double m);

/* Uniform within the cone whose half angle has 1 - cosine = `rise`: the
 * difference keeps its digits when the cone is narrow. By way of the disc,
 * whose middle a grid fills as evenly as its rim. */
vec3 warp_cone(const double u[2], vec3 axis, double rise);
double warp_cone_density(double rise);

/* Uniform over all directions; the density is 1/(4 pi). */
vec3 warp_sphere(const double u[2]);

#endif
