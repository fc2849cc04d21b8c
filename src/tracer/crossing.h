/* Where a ray meets a surface, and where it may go from there: what the
 * recursive tracer and the path tracer have in common. */
#ifndef TRACER_CROSSING_H
#define TRACER_CROSSING_H

#include "base/clones.h"
#include "shade/background.h"
#include "shade/facets.h"
#include "tracer/tracer.h"

/* One surface, and the list of bodies after crossing it. */
struct crossing {
    struct intersection at;
    struct surface surface;
    struct interiors beyond;
    bool leaving;
    double ior; /* behind the surface over before it */
};

/* Fills all but `at`, which is known. `inside` is what the ray came through and
 * must stay; layers below `bailout` are left out. `exact`: Fresnel's mirrors
 * are those of nature, not POV-Ray's, which differ inside several bodies. */
void crossing_fill(struct crossing *crossing, const struct tracer *tracer,
                   vec3 direction, const struct interiors *inside,
                   double bailout, bool exact);

/* The ior by which a plain leaf (world/solid.h) mirrors for such a ray. */
double crossing_plain_ior(const struct leaf *leaf,
                          const struct interiors *inside);

/* Of the crossing of a plain leaf what a ray that goes on asks for, of
 * POV-Ray's mirrors. */
void crossing_fill_facet(struct crossing *crossing, const struct facets *facets,
                         unsigned i);

/* Snell: the direction behind the surface; a normal that faces away from the
 * viewer is turned round. Returns false in total reflection. */
bool crossing_refracted(const struct crossing *crossing, vec3 direction,
                        vec3 normal, vec3 *out);

/* How many colours the light that passes is divided into: 1 where nothing has
 * dispersion, or the ray is of one colour already. */
int crossing_parts(const struct crossing *crossing,
                   const struct interiors *inside);

/* Makes the ray, in `inside`, one of the colour at this place of the spectrum.
 */
void crossing_divide(struct crossing *crossing, struct interiors *inside,
                     double place);

/* A ray goes on from a surface only while its level is below this. */
int tracer_levels(const struct tracer *tracer);

/* Whether fog reaches a ray that is inside of these. */
bool tracer_foggy(const struct tracer *tracer, const struct interiors *inside);

/* Whether rainbows are seen by it. */
bool tracer_arched(const struct tracer *tracer, const struct interiors *inside);

/* Whether there are media to be looked for. */
bool tracer_misty(const struct tracer *tracer);

/* The light of a ray that meets nothing: sky and background. `straight`: on the
 * camera's line of sight. *clear: the share of opacity that is still open. */
rgb tracer_background(const struct tracer *tracer, vec3 direction,
                      bool straight, double *clear);

/* The same where the sky in its direction is known. */
rgb tracer_beyond(const struct tracer *tracer, const struct veil *sky,
                  bool straight, double *clear);

/* The camera's ray at (x, y) of the picture, and what it starts in; counted. */
struct ray tracer_start(const struct tracer *tracer, struct worker *worker,
                        double x, double y, struct interiors *inside);

/* What a camera ray from there starts in; counted. */
void tracer_enter(const struct tracer *tracer, struct worker *worker,
                  vec3 origin, struct interiors *inside);

/* What a point is inside of. */
void tracer_inside(const struct tracer *tracer, vec3 point,
                   struct interiors *inside);

#endif
