/* What the mesh lighting is made of, and meshes of a size that has room. */
#ifndef LIGHTING_MESH_STATE_H
#define LIGHTING_MESH_STATE_H

#include "lighting/mesh_pixels.h"
#include "lighting/mesh_report.h"
#include "lighting/void_skeleton.h"
#include "lightmesh/indirect_pixels.h"
#include "lightmesh/knower.h"
#include "lightmesh/mesh_stamp.h"
#include "lightmesh/outlook.h"
#include "lightmesh/plan.h"
#include "lightmesh/survey.h"
#include "lightmesh/virtual_lights.h"

struct mesh_lighting {
    struct lamps lamps;
    struct ambience ambience;
    struct direct_mesh *direct;
    struct survey survey;
    struct plan plan;
    struct emitters *emitters;               /* with indirect light */
    struct virtual_lights *virtual_lights;   /* or NULL */
    struct indirect_mesh *indirect;          /* or NULL */
    struct indirect_pixels *indirect_pixels; /* likewise */
    struct void_skeleton close; /* what ends its bounces, if asked for */
    struct mesh_pixels pixels;  /* that lamps look at */
    struct knowers knowers;
    struct mesh_report report;
    /* How this picture's camera asks; what mesh points hold must not depend on
     * it, only on the stamp's frame. */
    struct lattice_view direct_view, indirect_view;
    struct plan_levels levels; /* of these views: 0 but for a mesh that is kept,
                                * or one like another's */
    struct mesh_stamp stamp;
    enum plan_film film;    /* what its picture is one of; */
    bool rooted;            /* its animation has a root, and something moves: */
    struct mesh_frame root; /* where that has its points */
    const struct mesh_lighting *now; /* whose are `close` and virtual_lights, if
                                      * it is smoothed by moments, or NULL */
    int width, height;               /* of the picture, pixels */
};

/* The meshes of the stamp's frame, without points. */
void mesh_make(struct mesh_lighting *mesh, const struct scene *scene,
               const struct interpolation *interpolation);
void mesh_clear(struct mesh_lighting *mesh);

/* Meshes whose points have room, as near to each other as the scene and the
 * picture want, or less. Returns false when stopped, or after an error was
 * printed: as near as was said they have none. */
bool mesh_fit(struct mesh_lighting *mesh, const struct scene *scene,
              const struct interpolation *interpolation,
              const struct outlook *outlook,
              const struct lighting_options *options, struct diag *diag);

#endif
