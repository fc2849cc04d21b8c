/* Media: matter that fills space and emits, swallows or scatters light there.
 * Plain data; how rays are marched through it is shade/media.h. */
#ifndef SCENE_MEDIUM_H
#define SCENE_MEDIUM_H

#include "scene/material.h"
#include "scene/spots.h"

enum { MEDIUM_INTERVALS_LIMIT = 10000 }; /* the parser refuses more */

/* How scattered light spreads: POV-Ray's numbers. */
enum phase {
    PHASE_NONE,
    PHASE_ISOTROPIC,
    PHASE_MIE_HAZY,
    PHASE_MIE_MURKY,
    PHASE_RAYLEIGH,
    PHASE_HENYEY_GREENSTEIN,
};

struct medium {
    rgb absorption, emission; /* a unit of length, where the density is 1 */
    rgb scattering;           /* likewise */
    enum phase phase;
    double eccentricity; /* of PHASE_HENYEY_GREENSTEIN, above -1, below 1 */
    double extinction;   /* of scattering: what it takes from light that goes
                          * straight on, 1 */
    const struct pigment **densities; /* their colours are multiplied */
    size_t density_count;
    /* How rays sample it: see shade/media.c. */
    int method, intervals, samples, samples_most, levels;
    double threshold, confidence, variance, ratio, jitter;
};

/* Nothing in it, and POV-Ray's settings. */
struct medium medium_default(void);

/* Density at a point of the medium's space; white if it has none of its own. */
rgb medium_density(const struct medium *medium, vec3 point);

/* The same of points side by side. */
void medium_densities(const struct medium *medium, const struct spots *points,
                      rgb *densities);

/* No component of the density is larger anywhere. */
rgb medium_density_most(const struct medium *medium);

/* Whether no light comes from it: it neither glows nor scatters. */
bool medium_is_dark(const struct medium *medium);

/* What light loses on a unit of length where the density is 1. */
rgb medium_extinction(const struct medium *medium);

/* The share of light, coming from everywhere alike in the mean, that is
 * scattered from one direction into another whose angle has this cosine (1:
 * straight on). Its mean over the sphere is 1, as far as POV-Ray's is. */
double medium_phase(const struct medium *medium, double cosine);

/* A copy in `arena`, its densities moved. */
const struct medium *medium_moved(struct arena *arena,
                                  const struct medium *medium,
                                  const affine *transform);

/* The list with one more, in `arena`; the old one stays as it is. */
struct media media_with(struct arena *arena, struct media media,
                        const struct medium *medium);

/* The interior itself if it has no media, else a copy whose media are moved. */
const struct interior *interior_moved(struct arena *arena,
                                      const struct interior *interior,
                                      const affine *transform);

#endif
