/* What glows close to a place: a tube under a ceiling, letters before a wall, a
 * ball on a table. Mesh points are too far from each other for its light, which
 * differs from place to place; they leave out what is near them, and places ask
 * for themselves, by rays all around and by picking points on what is near
 * (balance heuristic, Veach 1997, section 9.2). How much of it that is follows
 * from what glows and the distance to it alone, so that points and places
 * together lose nothing. All places look at the same parts of it, so that
 * neighbours don't differ by chance. */
#ifndef LIGHTMESH_NEAR_GLOW_H
#define LIGHTMESH_NEAR_GLOW_H

#include "lightmesh/gather.h"

struct near_glow;

/* Of all that emitters_pick finds, near as the view has mesh points around it.
 * NULL: there is none. Frees with near_glow_free; the emitters must outlive it.
 */
struct near_glow *near_glow_new(const struct world *world,
                                const struct emitters *emitters,
                                const struct lattice *lattice,
                                const struct lattice_view *view);
void near_glow_free(struct near_glow *near);

/* How much of the leaf's glow that is so far off places find by themselves: 1
 * near, 0 far. `near` may be NULL. */
double near_glow_share(const struct near_glow *near, const struct leaf *leaf,
                       double distance);

/* Where it is looked for. */
struct near_place {
    vec3 point, side; /* unit */
    rgb beside;       /* irradiance of other light: what adds little to it is
                       * looked for by few rays */
    double worth;     /* of what it gets in the picture, 0 to 1: likewise */
};

/* What of it arrives there: by direction into *light, as irradiance into
 * *arriving. Returns whether there is any in reach. `near` may be NULL. */
bool near_glow_find(const struct near_glow *near, const struct gather *gather,
                    struct worker *worker, const struct near_place *place,
                    struct indirect_light *light, rgb *arriving);

#endif
