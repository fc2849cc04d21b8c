/* Adaptive light meshes (section 4 of the light-mesh paper, which leaves them
 * open): where mesh points differ by more than a threshold, new ones are
 * asked between them, at half the distance, and so on. Levels of the lattice
 * nest, so that nothing that is known is computed again.
 *
 * How much they differ is a smooth function of the place, and the finer points
 * are blended in with it: there is no seam between cells. */
#ifndef LIGHTMESH_REFINE_H
#define LIGHTMESH_REFINE_H

#include "base/rgb.h"
#include "lightmesh/interpolation.h"

struct refinement {
    int levels;       /* how often the distance may be halved; 0: never */
    double threshold; /* from this relative difference on, > 0 */
};

/* Mesh points around a place. */
struct refine_views {
    int count;
    struct {
        rgb light;     /* on the place, if all were like this one */
        double weight; /* all together 1 */
    } at[INTERPOLATION_POINTS];
    double hidden; /* the share of those that can't see the place, 0..1 */
};

/* How far the points are apart, relative to what they are in the mean: of two
 * that count the same their difference; less than 4. One that can't see the
 * place counts as one that differs: it is at walls and in corners, where light
 * changes fast, as the points that are left may not tell. */
double refine_difference(const struct refine_views *views);

/* The share that finer points have where points differ so much: 0 up to the
 * threshold, 1 from twice that on. */
double refine_share(const struct refinement *refinement, double difference);

#endif
