/* Surfaces that glow as lamps: a point of one is picked by area and power, or
 * on a ball by the solid angle it fills, with the density that multiple
 * importance sampling needs (Veach 1997, section 9.2). Surfaces whose shape
 * has no patches have some points strewn over them that stand for the rest, or
 * are left to chance. Both sides glow. */
#ifndef SHADE_EMITTERS_H
#define SHADE_EMITTERS_H

#include <math.h>

#include "world/world.h"

struct emitters;

/* Frees with emitters_free. `strewn`: points of the surface may stand for it,
 * which is off by a few in a hundred. */
struct emitters *emitters_new(const struct world *world, bool strewn);
void emitters_free(struct emitters *emitters);

/* Whether there is anything to pick. */
bool emitters_any(const struct emitters *emitters);

/* A direction in which something glows, unless it is hidden. */
struct emitter_pick {
    const struct leaf *leaf; /* what */
    vec3 direction;          /* unit */
    double distance;         /* where on the leaf; INFINITY: anywhere */
    double density;          /* per solid angle, of this direction and place */
};

/* Picks for a point, by three numbers in [0,1). False: nothing there. */
bool emitters_pick(const struct emitters *emitters, vec3 point, double which,
                   const double u[2], struct emitter_pick *pick);

/* Whether what a ray in its direction met is what was picked. */
bool emitter_is_met(const struct emitter_pick *pick,
                    const struct intersection *at);

/* What is picked of one leaf: where `which` is within `share` from `from` on.
 */
struct emitter_share {
    const struct leaf *leaf;
    double from, share; /* of 1 */
};

/* Those of all leaves, which stay the emitters'. Returns how many. */
size_t emitters_shares(const struct emitters *emitters,
                       const struct emitter_share **shares);

/* The density with which emitters_pick finds what a ray from `point` met at
 * `at`; 0 if it never does. For smooth triangles that of the interpolated
 * normal, which serves as well for weights. */
double emitters_density(const struct emitters *emitters, vec3 point,
                        vec3 direction, const struct intersection *at);

/* How much what was found with that density counts where another way finds it
 * with density `other`: the balance heuristic. Nothing where the other can't
 * miss it. */
static inline double emitters_balance(double density, double other)
{
    return density > 0 && isfinite(other) ? density / (density + other) : 0;
}

#endif
