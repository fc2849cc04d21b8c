/* The path tracer, `--lighting path`: the reference that other methods are held
 * against. Unbiased: the mean of samples tends to the exact answer of the
 * scene's model (integrator/path.c says what that is). */
#ifndef TRACER_PATH_H
#define TRACER_PATH_H

#include "tracer/integrator.h"

/* One sample of what the camera sees at (x, y) of the picture, both in [0,1].
 * `draws` must be of this pixel and sample; the tracer's lighting is
 * path_lighting. */
struct radiance path_camera(const struct tracer *tracer, struct worker *worker,
                            double x, double y, const struct draws *draws);

/* Finds for guided paths how bright the picture is; without it they aim, but
 * don't split. The worker counts the rays. */
void path_ready(struct tracer *tracer, struct worker *worker);

/* With a unit normal: the irradiance of that side, in POV-Ray's units (a lamp
 * gives colour * cosine, a glowing hemisphere its radiance), of which a surface
 * there makes diffuse * pigment * irradiance. With NULL: the scalar light
 * field, without the cosine: a lamp gives its colour, surroundings of radiance
 * 1 give 4. `samples` >= 2 for an error; the answer depends on the arguments
 * and the seed, not on the worker. */
struct path_light path_irradiance(const struct tracer *tracer,
                                  struct worker *worker, vec3 point,
                                  const vec3 *normal, unsigned samples,
                                  uint64_t seed);

#endif
