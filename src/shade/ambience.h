/* What `ambient` stands for: light that comes in from outside, wherever a ray
 * leaves the scene. A surface under the open sky has all of POV-Ray's ambient
 * term, one in a corner less, one in a closed room none; sky and background
 * themselves light nothing. Where they do (radiosity {}, light_mesh { sky on })
 * there is no ambient light, but beside radiosity before version 3.7: there
 * surfaces have it of their own, whatever is around. */
#ifndef SHADE_AMBIENCE_H
#define SHADE_AMBIENCE_H

#include "base/worker.h"
#include "scene/scene.h"
#include "shade/surface.h"

struct ambience {
    const struct scene *scene;
    bool sky;        /* sky and background are lamps: the rest is 0 */
    bool everywhere; /* nothing stands before this light: no lamp is on and
                      * nothing glows, so nothing else would be seen; or it is
                      * beside radiosity */
    rgb light;       /* multiplies finish ambient */
    double share;    /* what surfaces make of it over what they make of other
                      * light: the mean of ambient / diffuse, at most 1 */
};

struct ambience ambience_new(const struct world *world,
                             const struct scene *scene);

/* What a ray brings that leaves the scene in this unit direction, as light that
 * surfaces scatter like any other. Exact if sky and background are lamps; else,
 * where only the ambient light of a mean surface is wanted. */
rgb ambience_beyond(const struct ambience *ambience, vec3 direction);

/* How open the scene is along the ray, 0 to 1: past what it meets of panes and
 * by what mirrors show, and 1 where it meets nothing. What glows by its ambient
 * light is sky as well. */
double ambience_open(const struct ambience *ambience, const struct world *world,
                     struct worker *worker, const struct ray *ray);

/* How much of a surface is such a sky. Of that part what lies beyond is all
 * that it sends to other surfaces: lamps light no sky. */
double surface_sky(const struct surface *surface);

/* What it makes of ambient light 1. */
rgb surface_ambient(const struct surface *surface);

#endif
