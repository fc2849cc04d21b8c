/* What may stand between a point and an area light: the shaft from the one to
 * the other (Haines and Wallace 1991, Shaft Culling for Efficient Ray-Traced
 * Radiosity) against a tree of boxes. Most shafts are empty, most others hold
 * one or two solids, and a shadow ray need look at nothing else. */
#ifndef WORLD_SHAFT_H
#define WORLD_SHAFT_H

#include "scene/rays.h"
#include "world/flatten.h"

enum { SHAFT_SOLIDS = 8 };

/* All rays from a point, or from a piece of a surface, to a parallelogram. */
struct shaft_rays {
    vec3 from;
    double radius; /* they begin within so far of it, on the same surface */
    vec3 middle, half[2]; /* of the parallelogram: middle +- half[0] +- half[1],
                           * whose points have coordinates in [-1,1]^2 */
    double tmin;
    /* What `from` is on, and its true normal there, outward; or NULL, but not
     * with a radius. */
    const struct leaf *leaf;
    vec3 normal;
    double bend; /* no normal of the piece differs by a longer vector */
};

/* What such rays may meet, other than farther than the parallelogram or nearer
 * than tmin: solids, and where rays must go to meet them. */
struct shaft {
    bool crowded; /* too much, or triangles: the list says nothing */
    bool plain;   /* only opaque shapes: shaft_hides may be asked */
    int count;
    struct shaft_solid {
        const struct solid *solid;
        double low[2], high[2]; /* coordinates in the parallelogram */
    } at[SHAFT_SOLIDS];
};

/* Whether a ray to the place of these coordinates may meet one of them. */
static inline bool shaft_shades(const struct shaft_solid *solid,
                                const double place[2])
{
    return place[0] >= solid->low[0] && place[0] <= solid->high[0] &&
           place[1] >= solid->low[1] && place[1] <= solid->high[1];
}

/* Whether rays to that place surely meet nothing. */
static inline bool shaft_clear(const struct shaft *shaft, const double place[2])
{
    if (shaft->crowded)
        return false;
    for (int i = 0; i < shaft->count; i++)
        if (shaft_shades(&shaft->at[i], place))
            return false;
    return true;
}

/* Whether a crossing lies on the ray, of any length, to the place of these
 * coordinates between tmin and tmax. */
bool shaft_hides(const struct shaft *shaft, const double place[2],
                 const struct ray *ray, double tmin, double tmax);

/* The same of rays side by side, those of `lanes`, in their spans. */
unsigned shaft_hides_many(const struct shaft *shaft,
                          const double (*place)[RAY_LANES],
                          const struct rays *rays, const struct rays_span *span,
                          unsigned lanes);

/* Looks at what is in it with a packet of rays to these places. */
struct packet;
void shaft_look(const struct shaft *shaft, const double (*place)[RAY_LANES],
                struct packet *packet);

/* Which rays to those places may meet something, as shaft_clear. */
unsigned shaft_shaded_many(const struct shaft *shaft,
                           const double (*place)[RAY_LANES]);

struct shaft_tree;

void shaft_find(const struct shaft_tree *tree, const struct shaft_rays *rays,
                struct shaft *shaft);

/* How wide the penumbra of the parallelogram is, at least, where the rays
 * begin: what stands at part s of the way casts one that is s / (1 - s) times
 * as wide as the light is to it. HUGE_VAL: nothing may stand there. Widths
 * below `enough` aren't told apart. */
double shaft_blur(const struct shaft_tree *tree, const struct shaft_rays *rays,
                  double enough);

#endif
