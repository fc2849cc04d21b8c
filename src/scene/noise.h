/* Solid noise and its octaves; see noise.c for the source. Defined at every
 * point: where a coordinate isn't finite or is beyond 2^40 the noise still has
 * a value, only its features are lost. */
#ifndef SCENE_NOISE_H
#define SCENE_NOISE_H

#include "base/vec.h"
#include "scene/pattern.h"
#include "scene/spots.h"

/* POV-Ray's three, by their numbers. They differ in the scalar noise only. */
enum noise_generator {
    NOISE_CLIPPED = 1, /* cut to [0,1] */
    NOISE_SCALED = 2,  /* the same, scaled to fit */
    NOISE_PERLIN = 3,  /* other gradients and no values */
};

/* What global_settings say for all patterns. */
struct noise_settings {
    enum noise_generator generator;
    int waves; /* of `waves` and `ripples`: 1 to NOISE_WAVES_LIMIT */
};

enum { NOISE_WAVES = 10, NOISE_WAVES_LIMIT = 1000 };
extern const struct noise_settings noise_settings_default;

/* Smooth noise in [0,1], one feature per unit. */
double noise_value(enum noise_generator generator, vec3 point);

/* The same at several spots. */
void noise_values(enum noise_generator generator, const struct spots *spots,
                  double *values);

/* Noise of several sizes: each octave is looked up at lambda times the place of
 * the one before; the first one's place is the point. */
enum { OCTAVES_MAX = 10 };
struct octaves {
    int count;
    double first, lambda; /* what the point is multiplied by, once and again */
};

/* As wide as NOISE_CLIPPED, but not cut: what granite, wrinkles and turbulence
 * are made of. The first octave of all spots, then the next one ... */
void noise_octaves(enum noise_generator generator, const struct spots *spots,
                   struct octaves octaves, double *values);

/* A smooth random vector field, components about [-1,1] and mostly within
 * +-0.5: the step of a `turbulence` with one octave. */
vec3 noise_vector(vec3 point);
void noise_vectors(const struct spots *spots, vec3 *vectors);

/* The first octave of all spots, then the next one ... */
void noise_vector_octaves(const struct spots *spots, struct octaves octaves,
                          vec3 *vectors);

/* The octaves POV-Ray would use: 1 to OCTAVES_MAX. */
int turbulence_octaves(const struct turbulence *turbulence);

/* Sums of octaves: frequency times lambda, weight times omega each. The scalar
 * is about 1 for the defaults and never says `amount`: marble and agate
 * multiply it themselves. Neither does the vector. */
void noise_turbulences(enum noise_generator generator,
                       const struct spots *spots,
                       const struct turbulence *turbulence, double *sums);
double noise_turbulence(enum noise_generator generator, vec3 point,
                        const struct turbulence *turbulence);
vec3 noise_vector_turbulence(vec3 point, const struct turbulence *turbulence);
void noise_vector_turbulences(const struct spots *spots,
                              const struct turbulence *turbulence, vec3 *sums);

/* Moves each spot by its turbulence. */
void noise_vectors_stir(struct spots *spots,
                        const struct turbulence *turbulence);

/* A random point of the unit cube that belongs to the cell (x, y, z). */
vec3 noise_cell_point(double x, double y, double z);

/* Circular waves, which spread from points of the unit sphere. */
struct noise_waves {
    double frequency, phase; /* cycles per unit; cycles */
    int count;               /* 1 to NOISE_WAVES_LIMIT */
    bool uneven; /* each has a frequency of its own, times the above, and is the
                  * higher the longer it is (`waves`); else their height is 1 */
};

/* Those of a pattern. */
struct noise_waves noise_waves_of(const struct pattern *pattern, bool uneven);

/* The mean of their heights at the point, and of their directions there times
 * their heights. */
double noise_waves_height(const struct noise_waves *waves, vec3 point);
void noise_waves_tilts(const struct noise_waves *waves,
                       const struct spots *spots, vec3 *tilts);

#endif
