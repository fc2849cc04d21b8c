/* What light meshes took, for --stats. */
#ifndef LIGHTING_MESH_REPORT_H
#define LIGHTING_MESH_REPORT_H

#include "lighting/lighting.h"
#include "lightmesh/indirect.h"
#include "lightmesh/penumbra.h"
#include "lightmesh/pixel_mesh.h"

/* Of lamps, in space and on surfaces, and of each bounce. */
enum { MESH_REPORTED_MAX = 2 + BOUNCES_MAX };

struct mesh_report {
    struct mesh_reported {
        char name[24];
        const struct point_mesh *points;
        struct lattice_view view; /* of what points hold */
    } of[MESH_REPORTED_MAX];
    size_t count;
    const struct pixel_mesh *pixels;   /* or NULL */
    const struct penumbras *penumbras; /* or NULL */
    double spacing;                    /* of mesh points */
    double size;                       /* across what is seen */
};

/* One more mesh, which must outlive it. */
void mesh_report_add(struct mesh_report *report, const char *name,
                     const struct point_mesh *points,
                     const struct lattice_view *view);

/* As tell of lighting/lighting.h. */
void mesh_report_tell(const struct mesh_report *report, lighting_row *row,
                      void *context);

#endif
