/* What stands close to a place: mesh points, which are some way off, see past
 * it. A few short rays from the place itself say how much of the light that the
 * points around know is hidden there, and what comes instead: a ball has its
 * shade where it lies on a table. All places look in the same directions, so
 * that neighbours don't differ by chance. */
#ifndef LIGHTMESH_NEAR_FIELD_H
#define LIGHTMESH_NEAR_FIELD_H

#include "lightmesh/gather.h"

struct indirect_mesh;
struct receiver;
struct worker;

/* Its rays look along these, around a z that is the side; nets of them
 * (base/draw.h) begin with the first. The caller frees them. */
vec3 *near_field_ways(const struct gather *gather, int rays);

/* What the receiver gets of *light, a blend of the mesh's points, by so many
 * rays; *light is mended as well, and the share is that of the receiver's side,
 * without bumps. What glows hides nothing: mesh points pick it. Where half of
 * the rays meet nothing the others are spared. */
struct indirect_share near_field_share(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       int rays, struct indirect_light *light);

/* How much what is so far off counts as what mesh points see past, of what is
 * within reach: 1 nearby, 0 out of it. */
double near_field_closeness(double distance, double reach);

#endif
