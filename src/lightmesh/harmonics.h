/* Light from all directions as 9 coefficients for each colour: spherical
 * harmonics up to order 2, and what a surface makes of it (Ramamoorthi and
 * Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps,
 * equations 3 and 10 to 12). In POV-Ray's units: a lamp of colour c straight
 * above a surface gives about c. */
#ifndef LIGHTMESH_HARMONICS_H
#define LIGHTMESH_HARMONICS_H

#include "base/rgb.h"
#include "base/vec.h"

enum { HARMONICS = 9 };

struct harmonics {
    float r[HARMONICS], g[HARMONICS], b[HARMONICS];
};

/* The basis at a unit direction, real and orthonormal. */
static inline void harmonics_basis(vec3 d, double basis[HARMONICS])
{
    basis[0] = 0.28209479177387814;
    basis[1] = 0.48860251190291992 * d.y;
    basis[2] = 0.48860251190291992 * d.z;
    basis[3] = 0.48860251190291992 * d.x;
    basis[4] = 1.0925484305920792 * d.x * d.y;
    basis[5] = 1.0925484305920792 * d.y * d.z;
    basis[6] = 0.31539156525252005 * (3 * d.z * d.z - 1);
    basis[7] = 1.0925484305920792 * d.x * d.z;
    basis[8] = 0.54627421529603959 * (d.x * d.x - d.y * d.y);
}

/* Adds light that comes from a unit direction. */
static inline void harmonics_add(struct harmonics *harmonics, vec3 direction,
                                 rgb light)
{
    double basis[HARMONICS];
    harmonics_basis(direction, basis);
    for (int i = 0; i < HARMONICS; i++) {
        harmonics->r[i] += (float)(light.r * basis[i]);
        harmonics->g[i] += (float)(light.g * basis[i]);
        harmonics->b[i] += (float)(light.b * basis[i]);
    }
}

/* sum += weight * from */
static inline void harmonics_mix(struct harmonics *sum,
                                 const struct harmonics *from, float weight)
{
    for (int i = 0; i < HARMONICS; i++)
        sum->r[i] += weight * from->r[i];
    for (int i = 0; i < HARMONICS; i++)
        sum->g[i] += weight * from->g[i];
    for (int i = 0; i < HARMONICS; i++)
        sum->b[i] += weight * from->b[i];
}

/* The same of one number instead of three: a share of what comes from there,
 * and what a surface gets of it, 0 to 1 where all directions are 1 or less. */
static inline void harmonics_add_share(float share[HARMONICS], vec3 direction,
                                       double amount)
{
    double basis[HARMONICS];
    harmonics_basis(direction, basis);
    for (int i = 0; i < HARMONICS; i++)
        share[i] += (float)(amount * basis[i]);
}

double harmonics_share(const float share[HARMONICS], vec3 normal);

/* All of it, from whatever direction: without cosines. */
rgb harmonics_total(const struct harmonics *harmonics);

/* The light on a surface with this normal, weighted with
 * max(0, cosine)^brilliance: Lambert's law for 1. Never negative. */
rgb harmonics_irradiance(const struct harmonics *harmonics, vec3 normal,
                         double brilliance);

/* The same of a mesh point's payload, for Lambert's law: a mesh_alone
 * (point_mesh.h). */
rgb harmonics_received(const void *context, vec3 place, vec3 normal,
                       const void *harmonics);

/* What each coefficient gives a surface with this normal. */
void harmonics_weights(vec3 normal, double brilliance,
                       double weights[HARMONICS]);

/* What they give together: light, no less than nothing, and a share, 0 to 1. */
rgb harmonics_weighted(const struct harmonics *harmonics,
                       const double weights[HARMONICS]);
double harmonics_weighted_share(const float share[HARMONICS],
                                const double weights[HARMONICS]);

/* What each coefficient gives a bump with this normal on a surface that is lit
 * on `side`: nothing of what comes from behind the surface, which is known at
 * the normal away from it. Of light that is even there a bump that faces away
 * by such a cosine gets the part (1 - cosine) / 2. */
void harmonics_bump(vec3 side, vec3 normal, double weights[HARMONICS]);

/* The light as if it came from one direction, the one where most of it comes
 * from: a unit vector, or zero if there is none. What comes from all sides
 * alike is no part of *light. */
vec3 harmonics_direction(const struct harmonics *harmonics, rgb *light);

#endif
