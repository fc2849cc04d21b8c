/* Where lamps send photons: at each target, all directions that may meet it. */
#ifndef TRACER_PHOTON_AIM_H
#define TRACER_PHOTON_AIM_H

#include "shade/lamps.h"

/* One lamp's photons for one target: a square of rows of them. */
struct photon_aim {
    const struct lamp *lamp;
    unsigned target;
    bool beam;   /* parallel rays from a disc, else a cone from the lamp */
    vec3 axis;   /* unit, of the cone or the beam */
    double rise; /* of the cone: 1 - cosine of its half angle, 2: everywhere */
    vec3 centre; /* of the disc, where the target is */
    double radius; /* of the disc */
    double extent; /* solid angle, or area of the disc */
    double across; /* area at the target, in units of the wanted spacing */
    int colours;   /* that the target divides light into: of each there are so
                    * many, where POV-Ray's photons divide; 0: it doesn't */
    size_t side;   /* photons in a row, and rows */
};

struct photon_aims {
    struct photon_aim *items; /* memory_free */
    size_t count;
    double spacing; /* of photons at their targets */
    double photons; /* all */
    bool many;      /* more than PHOTON_AIMS_MOST, of which these are a part */
};

enum { PHOTON_AIMS_MOST = 1000 * 1000 }; /* 200 MB of memory */

/* Every lamp and every target that it sends photons to. */
struct photon_aims photon_aims_new(const struct lamps *lamps);

/* One photon leaves. */
struct photon_start {
    struct ray ray; /* unit direction */
    double extent;  /* the part of the aim's solid angle, or area, that it
                     * stands for */
};

/* The photon of this row and place in it; `key`: its random numbers. False if
 * no light goes there. */
bool photon_aim_start(const struct photon_aim *aim, const struct lamps *lamps,
                      size_t row, size_t place, uint64_t key,
                      struct photon_start *start);

#endif
