/* Free paths through media, without bias: delta tracking (Woodcock et al.
 * 1965), with weights instead of colours of its own for each wavelength, and
 * ratio tracking (Novak, Selle and Jarosz 2014) for what gets through. */
#ifndef SHADE_FREE_PATH_H
#define SHADE_FREE_PATH_H

#include "shade/media.h"

/* Where a ray was scattered, and what it does there. */
struct collision {
    bool scattered; /* else it passed, or was lost: share is black */
    double t;
    vec3 direction; /* of the ray that was scattered */
    rgb light;      /* that the media gave on the way */
    rgb share;      /* of what comes after, the chance considered */
    int count;      /* media that scatter there: */
    const struct medium *media[MEDIA_MAX];
    rgb shares[MEDIA_MAX]; /* of the scattered light; their sum is white */
    double chances[MEDIA_MAX];
};

/* Follows the way; its numbers are drawn from the key. */
void free_path(const struct media_way *way, uint64_t key,
               struct collision *out);

/* An estimate of what gets through. */
rgb free_path_through(const struct media_way *way, uint64_t key);

/* What is scattered from a direction into the way's, mean 1 over the sphere as
 * far as POV-Ray's phase functions have it. */
rgb collision_phase(const struct collision *collision, vec3 direction);

/* A direction, about as likely as light comes from there; its density. */
vec3 collision_sample(const struct collision *collision, const double u[2],
                      double which);
double collision_density(const struct collision *collision, vec3 direction);

#endif
