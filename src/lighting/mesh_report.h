/* What light meshes took, for --stats, and the error that refuses a mesh that
 * does not fit into memory. */
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
    size_t bytes;                         /* that all meshes may have */
    bool again; /* a coarser mesh may be tried: nobody asked for this one */
};

/* Whether the meshes are full, and coarser ones are to be tried. */
bool mesh_report_again(const struct mesh_report *report);

/* As sound and tell of lighting/lighting.h. */
bool mesh_report_sound(const struct mesh_report *report, struct diag *diag);
void mesh_report_tell(const struct mesh_report *report, lighting_row *row,
                      void *context);

#endif
