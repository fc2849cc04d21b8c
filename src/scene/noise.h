/* Solid noise and its octaves; see noise.c for the source. Defined at every
 * point: where a coordinate isn't finite or is beyond 2^40 the noise still has
 * a value, only its features are lost. */
#ifndef SCENE_NOISE_H
#define SCENE_NOISE_H

#include "base/vec.h"
#include "scene/pattern.h"

/* Smooth noise in [0,1], one feature per unit: mean, spread and range as
 * POV-Ray's noise_generator 2. */
double noise_value(vec3 point);

/* A smooth random vector field, components about [-1,1] and mostly within
 * +-0.5: the step of a `turbulence` with one octave. */
vec3 noise_vector(vec3 point);

/* The octaves POV-Ray would use: 1 to 10. */
int turbulence_octaves(const struct turbulence *turbulence);

/* Sums of octaves: frequency times lambda, weight times omega each. The scalar
 * is about 1 for the defaults and never says `amount`: marble and agate
 * multiply it themselves. Neither does the vector. */
double noise_turbulence(vec3 point, const struct turbulence *turbulence);
vec3 noise_vector_turbulence(vec3 point, const struct turbulence *turbulence);

/* A random point of the unit cube that belongs to the cell (x, y, z). */
vec3 noise_cell_point(double x, double y, double z);

/* The unit vectors from which the waves of `waves` and `ripples` spread. */
enum { NOISE_WAVES = 10 };
vec3 noise_wave_source(int index);

#endif
