/* Embree's side of the world: one scene with the bounded solids as user
 * geometry and the triangles; or, where few solids are all, none (few.h). */
#ifndef WORLD_GEOMETRY_H
#define WORLD_GEOMETRY_H

#include "world/few.h"
#include "world/triangles.h"

struct geometry {
    RTCDevice device;
    RTCScene scene;
    struct triangles triangles;
    struct solid_list solids; /* bounded ones, by primitive */
    vec3 centre;              /* Embree's origin, in the world */
    struct box3 bounds;       /* of all there is; empty: nothing */
    double scale;   /* the largest coordinate of a triangle, from the centre */
    struct few few; /* solids, and no triangles: no scene of Embree's */
    bool coherent;  /* rays that are traced together are so to Embree: there are
                     * triangles mostly (measured) */
    struct diag *diag; /* while building */
    bool failed;
};

/* Builds on `threads` threads: flat->meshes and the bounded ones of
 * flat->solids; the others stay there. False after an error was printed;
 * geometry_free must be called all the same. */
bool geometry_build(struct geometry *geometry, struct flat *flat,
                    unsigned threads, double camera_rays, struct diag *diag);
void geometry_free(struct geometry *geometry, struct flat *flat);

/* Sends the query's ray through Embree's scene. */
void geometry_trace_scene(const struct geometry *geometry, struct query *query);

/* Sends the query's ray through; the results are in the query. There must be
 * something: `bounds` are not empty. */
static inline void geometry_trace(const struct geometry *geometry,
                                  struct query *query)
{
    if (geometry->few.solids)
        few_trace(&geometry->few, query);
    else
        geometry_trace_scene(geometry, query);
}

/* The same of a packet's open rays. */
void geometry_look(const struct geometry *geometry, struct packet *packet);

#endif
