/* What light meshes took, for --stats. */
#ifndef LIGHTING_MESH_REPORT_H
#define LIGHTING_MESH_REPORT_H

#include "lighting/lighting.h"
#include "lightmesh/indirect.h"
#include "lightmesh/penumbra.h"
#include "lightmesh/pixel_mesh.h"
#include "lightmesh/scalar.h"

struct mesh_report {
    const struct direct_mesh *direct;
    const struct indirect_mesh *indirect; /* or NULL */
    const struct scalar_mesh *scalar;     /* or NULL: in place of the two */
    const struct pixel_mesh *pixels;      /* or NULL */
    const struct penumbras *penumbras;    /* or NULL */
    double spacing;                       /* of mesh points */
    double size;                          /* across what is seen */
    struct lattice_view direct_view, indirect_view; /* of what points hold */
};

/* As tell of lighting/lighting.h. */
void mesh_report_tell(const struct mesh_report *report, lighting_row *row,
                      void *context);

#endif
