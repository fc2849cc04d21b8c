/* A place of a surface that asks the indirect mesh for places around it: where
 * it is, whom it serves, and what it knows. */
#ifndef LIGHTMESH_CORNER_H
#define LIGHTMESH_CORNER_H

#include "lightmesh/indirect.h"

struct corner {
    bool met; /* there is a surface that the camera sees: */
    vec3 point, side, from;
    double reach; /* how far it may serve, units */
};

struct corner_light {
    struct indirect_light light;
    struct indirect_share share; /* of a surface without bumps */
};

/* What the ray met, which is seen as `like` is. */
void corner_meet(struct corner *corner, const struct indirect_mesh *mesh,
                 const struct receiver *like, const struct ray *ray,
                 const struct intersection *at);

/* It is of the other side, seen from there. */
void corner_turn(struct corner *corner);

/* The receiver's own place. */
void corner_here(struct corner *corner, const struct indirect_mesh *mesh,
                 const struct receiver *receiver);

/* Who asks there, as `like` would, with a weight that makes mesh points so many
 * levels coarser (point_mesh_worth). */
struct receiver corner_receiver(const struct corner *corner,
                                const struct receiver *like, int coarser);

/* What the receiver at a corner gets, with short rays along `ways`. */
void corner_ask(struct corner_light *light, const struct indirect_mesh *mesh,
                struct worker *worker, const struct receiver *receiver,
                const struct near_ways *ways);

/* Whether both are on one surface, which may be bent, and near to each other.
 */
bool corner_serves(const struct corner *corner,
                   const struct receiver *receiver);

/* Whether nothing stands between, a little above the surface. */
bool corner_sees(const struct corner *corner, const struct indirect_mesh *mesh,
                 struct worker *worker, const struct receiver *receiver);

/* What that is to who is served: by how much its surface or its bumps are
 * turned from the corner's it gets what comes from there. */
struct indirect_share corner_share(const struct corner *corner,
                                   const struct corner_light *light,
                                   const struct receiver *receiver);

#endif
