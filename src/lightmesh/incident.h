/* The light of all lamps that arrives at a receiver, summed: on a piece of
 * surface all of it comes from before that, and is known as a vector, whose
 * cosine is exact; in space it comes from all around, as harmonics. */
#ifndef LIGHTMESH_INCIDENT_H
#define LIGHTMESH_INCIDENT_H

#include "lightmesh/facet_light.h"
#include "lightmesh/harmonics.h"
#include "lightmesh/receiver.h"

struct incident {
    bool around; /* which of the two */
    union {
        struct facet_light before;
        struct harmonics in_space;
    };
};

/* Its irradiance on the receiver, weighted with cosine^brilliance: Lambert's
 * law for 1. In POV-Ray's units, as struct diffuse_light. */
static inline rgb incident_irradiance(const struct incident *incident,
                                      const struct receiver *receiver,
                                      double brilliance)
{
    return incident->around
               ? harmonics_irradiance(&incident->in_space, receiver->normal,
                                      brilliance)
               : facet_light_irradiance(&incident->before, receiver->side,
                                        receiver->normal, brilliance);
}

/* As if it came from one direction, as harmonics_direction. */
static inline vec3 incident_direction(const struct incident *incident,
                                      rgb *from_there)
{
    return incident->around
               ? harmonics_direction(&incident->in_space, from_there)
               : facet_light_direction(&incident->before, from_there);
}

#endif
