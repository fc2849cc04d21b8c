/* Irradiance from spherical harmonics: see harmonics.h. */
#include "lightmesh/harmonics.h"

/* The zonal coefficients of max(0, cosine)^b: integrals of t^b P_l(t) over
 * [0,1], times 2 pi; for b = 1 pi, 2 pi / 3 and pi / 4. */
rgb harmonics_irradiance(const struct harmonics *harmonics, vec3 normal,
                         double brilliance)
{
    const double tau = 6.283185307179586;
    double basis[HARMONICS], b = brilliance;
    double order0 = tau / (b + 1), order1 = tau / (b + 2);
    double order2 = tau / 2 * (3 / (b + 3) - 1 / (b + 1));
    rgb light = rgb_grey(0);
    harmonics_basis(normal, basis);
    for (int i = 0; i < HARMONICS; i++) {
        double weight = basis[i] * (i == 0 ? order0 : i < 4 ? order1 : order2);
        light.r += weight * (double)harmonics->r[i];
        light.g += weight * (double)harmonics->g[i];
        light.b += weight * (double)harmonics->b[i];
    }
    return rgb_make(fmax(light.r, 0), fmax(light.g, 0), fmax(light.b, 0));
}
