/* What media are at places of a ray's way. */
#ifndef SHADE_MEDIA_PLACES_H
#define SHADE_MEDIA_PLACES_H

#include "scene/spots.h"
#include "shade/media.h"

/* At one place: light that is added, and what is lost, in a unit of length. */
struct media_sample {
    rgb light, depth;
};

/* Some of them side by side; `at` is filled in by who asks. */
struct places {
    int count;
    struct spots at;
    struct media_sample sample[SPOTS_MAX];
    rgb scattered[SPOTS_MAX];
};

/* What is lost in a unit of length at each spot: all that shadow rays ask.
 * Nothing is there once the worker is told to stop. */
void media_depths(const struct media_list *list, struct worker *worker,
                  const struct spots *spots, rgb *depths);

/* Fills in the samples. Lamps light the places if `lit`. Nothing is there once
 * the worker is told to stop. */
void media_samples(const struct media_way *way, bool lit,
                   struct places *places);

#endif
