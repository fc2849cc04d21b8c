/* A place that the camera sees and that asks the indirect mesh for places
 * around it: what it knows, and whom it serves. */
#ifndef LIGHTMESH_CORNER_H
#define LIGHTMESH_CORNER_H

#include "lightmesh/indirect.h"

struct corner {
    bool met; /* the camera sees a surface there: */
    vec3 point, side;
    double reach; /* how far it may serve, units */
    struct indirect_light light;
    struct indirect_share share; /* of a surface without bumps */
};

/* Who asks where the ray met something: like the other, which is near, with a
 * weight that makes points so many levels coarser (point_mesh_worth). */
struct receiver corner_receiver(const struct receiver *like,
                                const struct ray *ray,
                                const struct intersection *at, int coarser);

/* Where that is; it knows nothing yet. */
void corner_place(struct corner *corner, const struct indirect_mesh *mesh,
                  const struct receiver *receiver);

/* What a receiver at its place gets, with so many short rays. */
void corner_ask(struct corner *corner, const struct indirect_mesh *mesh,
                struct worker *worker, const struct receiver *receiver,
                int rays);

/* Whether both are on one surface, which may be bent, and near to each other.
 */
bool corner_serves(const struct corner *corner,
                   const struct receiver *receiver);

/* What it says to who is served. */
struct indirect_share corner_share(const struct corner *corner,
                                   const struct receiver *receiver);

/* Whether the receiver's bumps turn it from its surface: it takes what comes
 * from their own sides. */
bool receiver_is_bumpy(const struct receiver *receiver);

#endif
