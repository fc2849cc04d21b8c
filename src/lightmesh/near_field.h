/* What stands close to a place: mesh points, which are some way off, see past
 * it. A few short rays from the place itself say how much of the light that the
 * points around know is hidden there, and what comes instead: a ball has its
 * shade where it lies on a table. All places look in the same directions, so
 * that neighbours don't differ by chance. */
#ifndef LIGHTMESH_NEAR_FIELD_H
#define LIGHTMESH_NEAR_FIELD_H

#include "lightmesh/gather.h"
#include "lightmesh/onward.h"

struct indirect_mesh;
struct receiver;
struct worker;

/* Where its rays look, around a z that is the side: drawn by the cosine, as
 * evenly as so few can be. */
struct near_ways {
    int count;
    vec3 *ways;
};

/* Frees with near_ways_free. */
struct near_ways near_ways_new(int count);
void near_ways_free(struct near_ways *ways);

/* Units: mesh points that light the receiver may be so far from it, and see
 * past what is nearer. */
double near_field_reach_at(const struct indirect_mesh *mesh,
                           const struct receiver *receiver);

/* What is drawn for a place's ray of that number: the same for all places. */
struct draws near_draws(const struct gather *gather, unsigned number);

/* What is drawn where so many rays go on. */
struct onwards near_onwards_new(const struct gather *gather, int rays);

/* What a place gets by such rays. */
struct near_share {
    struct indirect_share share;
    double met; /* of the rays, those that meet something: 1 in a crevice */
};

/* What the receiver gets of *light, a blend of the mesh's points, by rays along
 * these ways; *light is mended as well, and the share is that of the receiver's
 * side, without bumps. `glow`, NULL: none, is what of near_glow.h is around: it
 * lights what is met. */
struct near_share near_field_share(const struct indirect_mesh *mesh,
                                   struct worker *worker,
                                   const struct receiver *receiver,
                                   const struct near_ways *ways,
                                   const struct indirect_light *glow,
                                   struct indirect_light *light);

/* Whether rays to it take so long that mesh points had better know all of it:
 * shapes that functions tell. */
bool near_is_dear(const struct leaf *leaf);

/* How much what is so far off counts as what mesh points see past, of what is
 * within reach: 1 nearby, 0 out of it. */
double near_field_closeness(double distance, double reach);

#endif
