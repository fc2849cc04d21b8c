/* The directions into which a surface scatters, as lobes: the diffuse share of
 * every layer, in front and behind. Highlights are of lamps alone, as in
 * POV-Ray, and mirrors are not lobes either. In POV-Ray's units a
 * response of 1 over the hemisphere weighted with the cosine is a share of 1:
 * light scattered = integral of response * radiance / pi. */
#ifndef TRACER_LOBES_H
#define TRACER_LOBES_H

#include "lighting/guide.h"
#include "shade/surface.h"

enum { LOBES_MAX = 2 * TEXTURE_LAYERS + GUIDE_TARGETS };

struct lobe {
    vec3 axis;
    double power; /* density goes with cosine^power */
    double share; /* of all lobes, then the chance to be chosen */
};

struct lobes {
    int count;
    double light; /* indirect irradiance, about; 0: not known */
    double total; /* about the share of light that they scatter, largest of
                   * the colours */
    struct lobe at[LOBES_MAX];
};

void lobes_fill(struct lobes *lobes, const struct surface *surface);

/* The lobe of a plate that light falls on. */
void lobes_fill_plate(struct lobes *lobes, vec3 normal);

/* Tells about how much indirect light there is, and, unless lamps are seen
 * (`lit`: then it comes from all around), adds lobes to where it is expected,
 * which take part of the diffuse ones' chance. NULL: nothing is known. */
void lobes_guide(struct lobes *lobes, const struct guide *guide, vec3 point,
                 vec3 normal, bool lit);

/* A direction by three numbers in [0,1), and the density of all lobes for a
 * direction, per solid angle. There must be lobes. */
vec3 lobes_sample(const struct lobes *lobes, double which, const double u[2]);
double lobes_density(const struct lobes *lobes, vec3 direction);

/* The light that goes to the viewer of white light from there, cosine and all
 * layers' weights included. */
rgb surface_response(const struct surface *surface, vec3 direction,
                     bool highlights);

#endif
