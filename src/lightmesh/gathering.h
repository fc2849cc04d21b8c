/* A gather ray on its way: where it goes (gather.c), and what arrives at the
 * surfaces that it meets (gather_arriving.c). */
#ifndef LIGHTMESH_GATHERING_H
#define LIGHTMESH_GATHERING_H

#include "lightmesh/gather.h"

struct gathering {
    const struct gather *gather;
    struct worker *worker;
    const struct draws *draws;
    struct ray ray;
    rgb share;    /* of what it meets next */
    double *open; /* the sum of what leaves the scene */
    rgb *lamps;   /* what the first surface sends of lamps' light */
    int mirrors;
    int inside;           /* bodies that it has come into */
    uint32_t met;         /* surfaces */
    int before;           /* surfaces that scattered what it brings */
    bool known;           /* what it meets next has been found */
    const rgb *lamplight; /* on the first surface that it meets, on the side
                           * that it comes to; NULL: to be found */
};

/* All light. What is met first into *first, and that one's own light into
 * *glow, where these are wanted. */
rgb gathering_follow(struct gathering *gathering, struct intersection *first,
                     rgb *glow);

/* The light on the surface that it met, of which the share `matters` is seen:
 * on the side that it came to, and the part `behind` of what arrives on the
 * other. */
struct indirect_share gathering_arriving(const struct gathering *gathering,
                                         const struct surface *surface,
                                         double behind, double matters);

#endif
