/* Solid noise and its gradient; see noise.c for the source. */
#ifndef SCENE_NOISE_H
#define SCENE_NOISE_H

#include "base/vec.h"
#include "scene/pattern.h"

/* Smooth noise in [0,1], mean and spread as POV-Ray's noise_generator 2. */
double noise_value(vec3 point);

/* A smooth random vector field, components about [-1,1]. */
vec3 noise_vector(vec3 point);

/* Sums of octaves: frequency times lambda, weight times omega each. */
double noise_turbulence(vec3 point, const struct turbulence *turbulence);
vec3 noise_vector_turbulence(vec3 point, const struct turbulence *turbulence);

#endif
