/* `model scalar`: surfaces lit by the paper's own equations. */
#ifndef LIGHTING_MESH_SCALAR_H
#define LIGHTING_MESH_SCALAR_H

#include "lighting/lamplight.h"
#include "lightmesh/scalar.h"

/* (2) to the light's visitor and (5) as its irradiance. The tracer multiplies
 * both by kd, where (6) has it only before I~d: else lamps would show no
 * colours. It adds Emiss, and ks I(Q) of (8) along the mirror ray. */
struct diffuse_light mesh_scalar_light(const struct scalar_mesh *mesh,
                                       const struct lamplight *light);

#endif
